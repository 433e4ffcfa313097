// A day's work in the studio, by a program that is killed at its end: day_of_work FOLDER. All of it is real: the runs,
// the calibration, the report. What stands in FOLDER when the file "ready" appears is what KilledDayTest.cpp expects
// back.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QPlainTextEdit>
#include <QSettings>
#include <QSpinBox>
#include <QTest>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "results/SignalTable.h"
#include "simulation/RunCase.h"
#include "studio/common/MessageBar.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/tools/CalibrationForm.h"
#include "studio/tools/KeyRows.h"
#include "studio/tools/TargetList.h"
#include "studio/tools/ToolWindow.h"
#include "studio/window/MainWindow.h"

namespace {

using namespace squat;
using studio::MainWindow;

constexpr int patience = 700000;  // [ms]

// What does not happen ends the day: the test waits for it in vain and prints this.
void require(bool happened, const char* what) {
  if (happened) return;
  std::fprintf(stderr, "day_of_work: %s\n", what);
  std::exit(1);
}

bool passes(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, patience); }

void set(MainWindow& window, const char* key, const QString& value) {
  require(!window.document().setParameter(key, value.toStdString()), key);
}

// A tenth of a second each on the coarsest mesh.
void runTen(MainWindow& window, const QDir& folder) {
  window.openCase("light-defect");
  set(window, "mesh.preset", "tiny"), set(window, "motion.run_up", "0.06"), set(window, "motion.beyond", "0.07");
  require(window.saveCaseTo(folder.filePath("dip.toml")), "the case is not saved");
  require(window.saveProjectTo(folder.filePath("day.squat-project")), "the project is not saved");
  for (int i = 1; i <= 10; ++i) {
    set(window, "defect.depth", QString::number(0.05 + 0.01 * i));
    window.startRun();
    require(window.controller().waitFor(patience), "a run does not end");
  }
  require(window.store().rowCount() == 10, "there are not ten runs");
  window.store().rename(2, "the third one");
}

void overlayAndCalibrate(MainWindow& window, const QDir& folder) {
  const QString measured = folder.filePath("measured.csv");
  results::writeSignalTable(measured.toStdString(), *window.store().at(4).result);
  require(window.openMeasured(measured), "the measured signal is not read");
  studio::ToolWindow* tool = window.tool("calibration");
  tool->setFolder(folder.filePath("calibration"));
  auto* form = qobject_cast<studio::CalibrationForm*>(tool->form());
  form->findChild<studio::KeyRows*>()->setTexts({"pad.stiffness=1000:1800", "defect.depth=0.05:0.15"});
  form->targets()->addSignal(10);
  form->findChild<QComboBox*>("confirmMesh")->setCurrentText("tiny");
  form->findChild<QSpinBox*>("evaluations")->setValue(10);
  tool->start();
  require(passes([&] { return !tool->isBusy(); }), "the calibration does not end");
  require(!tool->text().isEmpty(), qPrintable(tool->messages()->text()));
}

// Name and digest of every file, the project's last.
void writeInventory(const QDir& folder) {
  QByteArray list;
  QDirIterator files(folder.path(), QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next(), name = folder.relativeFilePath(path);
    if (name.startsWith("state/") || name == "ready") continue;
    QFile file(path);
    require(file.open(QIODevice::ReadOnly), "a file cannot be read");
    list += QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256).toHex() + ' ' + name.toUtf8() + '\n';
  }
  QFile inventory(folder.filePath("state/inventory"));
  require(inventory.open(QIODevice::WriteOnly) && inventory.write(list) == list.size(), "no inventory");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName("squat-studio-tests");
  const QDir folder(argv[1]);
  folder.mkpath("state");
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.filePath("state/settings"));
  studio::StudioServices services;
  services.runner = simulation::runCase;
  services.recoveryFolder = folder.filePath("state/recovery");
  services.runsFolder = folder.filePath("state/runs");
  MainWindow window(services);
  window.show();
  runTen(window, folder);
  overlayAndCalibrate(window, folder);
  window.notes()->insertPlainText("Pads of the second bogie?\n");
  require(window.saveReportTo(folder.filePath("day.pdf")), qPrintable(window.messages()->text()));
  // The case is long again, and not saved: its run is under way when the program dies.
  set(window, "mesh.preset", "draft"), set(window, "motion.beyond", "0.4");
  window.keeper()->saveNow();
  writeInventory(folder);
  window.startRun();
  require(passes([&] { return window.controller().isRunning(); }), "the last run does not start");
  QFile ready(folder.filePath("ready"));
  require(ready.open(QIODevice::WriteOnly), "cannot say that it is ready");
  ready.close();
  return QApplication::exec();
}
