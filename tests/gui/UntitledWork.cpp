// Work in a window without a project, by a program that is killed while it goes on: untitled_work FOLDER. Each thing
// that was done stands in FOLDER/log with its time [ms] once it is done: "1764378000123 run 3".
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTest>
#include <clocale>

#include "gui/MadeUpRun.h"
#include "studio/project/NotesPanel.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/ToolWindow.h"
#include "studio/window/MainWindow.h"

namespace {

using namespace squat;

class Work {
 public:
  explicit Work(const QDir& folder) : folder_(folder), log_(folder.filePath("log")) {
    services_.runner = tests::madeUpRunner(15);
    services_.recoveryFolder = folder.filePath("recovery");
    services_.runsFolder = folder.filePath("runs");
    window_ = std::make_unique<studio::MainWindow>(services_);
    window_->show();
  }

  int go() {
    if (!log_.open(QIODevice::WriteOnly) || !window_->openCase("light-defect")) return 1;
    for (int i = 1;; ++i) {
      window_->notes()->insertPlainText(QStringLiteral("%1 ").arg(i));
      done("notes", i);
      if (i % 4 == 0) speed(i);
      if (i % 6 == 0) run(i / 6);
      if (i == 9) measured();
      if (i == 13) records();
      QTest::qWait(60);
    }
  }

 private:
  void done(const char* what, int value) {
    log_.write(QByteArray::number(QDateTime::currentMSecsSinceEpoch()) + ' ' + what + ' ' + QByteArray::number(value) +
               '\n');
    log_.flush();
  }
  void speed(int value) {
    window_->document().setParameter("motion.speed", std::to_string(20 + 0.05 * value));
    done("speed", value);
  }
  void run(int number) {
    window_->startRun();
    if (window_->controller().waitFor(60000) && window_->store().rowCount() > 0) done("run", number);
  }
  void measured() {
    if (window_->openMeasured(folder_.filePath("measured.csv"))) done("measured", 1);
  }
  void records() {
    project::LongRecords kept;
    kept.files = {folder_.filePath("ride.csv").toStdString()};
    kept.speed = 25;
    qobject_cast<studio::DetectionForm*>(window_->tool("squats")->form())->setChoices(kept);
    window_->findChild<QAction*>("squatsAction")->trigger();
    done("records", 1);
  }

  QDir folder_;
  QFile log_;
  studio::StudioServices services_;
  std::unique_ptr<studio::MainWindow> window_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName("squat-studio-tests");
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QDir(argv[1]).filePath("settings"));
  return Work(QDir(argv[1])).go();
}
