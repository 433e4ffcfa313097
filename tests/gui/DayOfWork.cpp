// A day's work in the studio, by a program that closes its window at noon and is killed at its end: day_of_work FOLDER.
// All of it is real: the profile from a file, the runs, the calibration, the report. What stands in FOLDER when the
// file "ready" appears is what KilledDayTest.cpp expects back.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCryptographicHash>
#include <QDialog>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "gui/Hands.h"
#include "results/SignalTable.h"
#include "simulation/RunCase.h"
#include "studio/common/MessageBar.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
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

// By the buttons, as a user does.
void importProfile(MainWindow& window, const QDir& folder) {
  QFile file(folder.filePath("dip.csv"));
  require(file.open(QIODevice::WriteOnly), "no profile");
  file.write("position [mm];height [um]\n-20;0\n-10;-50,5\n0;-100\n10;-50,5\n20;0\n");
  file.close();
  tests::FileDialogTyping typing(file.fileName());
  tests::click(*window.findChild<QToolButton*>("importProfile"));
  require(typing.done(), "the profile is not chosen");
  auto* dialog = window.findChild<QDialog*>("importDialog");
  require(dialog && QTest::qWaitForWindowExposed(dialog), "the profile is not shown");
  tests::click(*dialog->findChild<QPushButton*>("takeProfile"));
  require(window.document().description().defect.points.size() == 5, "the profile is not taken");
}

// A tenth of a second each on the coarsest mesh.
void runTen(MainWindow& window, const QDir& folder) {
  window.openCase("light-defect");
  importProfile(window, folder);
  set(window, "mesh.preset", "tiny"), set(window, "motion.run_up", "0.06"), set(window, "motion.beyond", "0.07");
  require(window.saveCaseTo(folder.filePath("dip.toml")), "the case is not saved");
  require(window.saveProjectTo(folder.filePath("day.squat-project")), "the project is not saved");
  for (int i = 1; i <= 10; ++i) {
    set(window, "defect.height_scale", QString::number(0.5 + 0.1 * i));
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
  form->findChild<studio::KeyRows*>()->setTexts({"pad.stiffness=1000:1800", "defect.height_scale=0.5:1.5"});
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
  {
    MainWindow morning(services);
    morning.show();
    require(QTest::qWaitForWindowExposed(&morning), "no window");
    runTen(morning, folder);
    require(morning.close(), "the window does not close");
  }
  MainWindow window(services);
  window.show();
  require(window.openProject(folder.filePath("day.squat-project")), qPrintable(window.messages()->text()));
  require(window.reader()->waitFor(patience), "the runs are not read");
  require(window.store().rowCount() == 10 && window.store().at(2).label == "the third one", "runs are missing");
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
