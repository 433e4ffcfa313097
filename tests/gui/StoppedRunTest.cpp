// A run that was stopped, or that ended with the program, goes on when its case is open again.
#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "simulation/RunCase.h"
#include "studio/common/MessageBar.h"
#include "studio/runs/RunPanel.h"

namespace squat::studio {
namespace {

constexpr int patience = 60000;  // [ms] for slow machines
constexpr int steps = 1500;      // of the made-up run: one a millisecond

class StoppedRun : public testing::Test {
 protected:
  std::unique_ptr<MainWindow> open(int milliseconds = steps) {
    StudioServices services = tests::services(milliseconds);
    services.runsFolder = folder_.path();
    auto window = std::make_unique<MainWindow>(services);
    window->openCase("light-defect");
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    return window;
  }
  static QPushButton& goOn(MainWindow& window) { return *window.findChild<QPushButton*>("goOn"); }
  static QString log(MainWindow& window) {
    return window.findChild<RunPanel*>()->findChild<QPlainTextEdit*>()->toPlainText();
  }
  // F5, then Shift+F5 as soon as the run tells something.
  static void runAndCancel(MainWindow& window) {
    tests::press(window, Qt::Key_F5);
    ASSERT_TRUE(tests::passes([&] { return log(window).contains("begins"); }, patience));
    tests::press(window, Qt::Key_F5, Qt::ShiftModifier);
    ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }, patience));
  }
  QTemporaryDir folder_;
};

TEST_F(StoppedRun, isOfferedForItsOwnCaseOnly) {
  const auto window = open();
  EXPECT_FALSE(goOn(*window).isVisible());
  EXPECT_FALSE(window->findChild<QAction*>("goOnAction")->isEnabled());
  runAndCancel(*window);
  EXPECT_TRUE(goOn(*window).isVisible());
  EXPECT_TRUE(goOn(*window).isEnabled());
  window->document().setParameter("motion.speed", "25");
  EXPECT_FALSE(goOn(*window).isVisible());
  EXPECT_FALSE(window->findChild<QAction*>("goOnAction")->isEnabled());
  window->document().undoStack().undo();
  EXPECT_TRUE(goOn(*window).isVisible());
}

// Hours may stand in its checkpoint, which a new run of the case would replace.
TEST_F(StoppedRun, isNotLetGoUnasked) {
  QStringList questions;
  Answer answer = Answer::cancel;
  StudioServices services = tests::services(steps);
  services.runsFolder = folder_.path();
  services.asker = [&](QWidget*, const QString& question, const QString&) {
    questions << question;
    return answer;
  };
  MainWindow window(services);
  window.openCase("light-defect");
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  runAndCancel(window);
  ASSERT_TRUE(questions.isEmpty());
  window.startRun();
  EXPECT_FALSE(window.controller().isRunning());
  EXPECT_EQ(questions.size(), 1);
  EXPECT_TRUE(window.findChild<QAction*>("goOnAction")->isEnabled());
  answer = Answer::discard;
  window.startRun();
  EXPECT_TRUE(window.controller().isRunning());
}

TEST_F(StoppedRun, goesOnAndTakesThePlaceOfItsFirstPart) {
  const auto window = open();
  runAndCancel(*window);
  ASSERT_EQ(window->store().rowCount(), 1);
  tests::click(goOn(*window));
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, patience));
  EXPECT_FALSE(log(*window).contains("step 0")) << log(*window).toStdString();
  EXPECT_FALSE(goOn(*window).isVisible());
  ASSERT_TRUE(tests::passes([&] { return !window->controller().isRunning(); }, patience));
  ASSERT_EQ(window->store().rowCount(), 1);
  EXPECT_TRUE(window->store().currentResult()->complete);
  EXPECT_FALSE(goOn(*window).isVisible());  // there is nothing left to do
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

TEST_F(StoppedRun, beginsAnewWhereThatIsWished) {
  const auto window = open();
  runAndCancel(*window);
  tests::press(*window, Qt::Key_F5);
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, patience));
  EXPECT_TRUE(log(*window).contains("begins at step 0"));
  window->controller().cancel();
  ASSERT_TRUE(window->controller().waitFor(patience));
}

TEST_F(StoppedRun, survivesTheEndOfTheProgram) {
  {
    const auto window = open();
    tests::press(*window, Qt::Key_F5);
    ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, patience));
    EXPECT_TRUE(window->close());  // the question is answered: stop it
  }
  const auto window = open();
  EXPECT_TRUE(goOn(*window).isVisible());
  tests::press(*window, Qt::Key_F5, Qt::ControlModifier);
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, patience));
  EXPECT_FALSE(log(*window).contains("step 0"));
  window->controller().cancel();
  ASSERT_TRUE(window->controller().waitFor(patience));
}

TEST_F(StoppedRun, onlyTheNewestFewAreKept) {
  const QDir folder(folder_.path());
  for (int i = 0; i < 9; ++i) {
    QFile file(folder.filePath(QString::number(i) + ".checkpoint"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_TRUE(file.setFileTime(QDateTime(QDate(2020, 1, 1 + i), QTime(0, 0)), QFileDevice::FileModificationTime));
  }
  const StoppedRuns runs(folder_.path());
  EXPECT_EQ(folder.entryList(QDir::Files, QDir::Name),
            QStringList({"5.checkpoint", "6.checkpoint", "7.checkpoint", "8.checkpoint"}));
}

TEST_F(StoppedRun, aCheckpointThatIsNoneIsTold) {
  StudioServices services = tests::services();
  services.runner = simulation::runCase;
  services.runsFolder = folder_.path();
  MainWindow window(services);
  window.openCase("light-defect");
  QFile file(StoppedRuns(folder_.path()).file(window.document().description()));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("not a checkpoint");
  file.close();
  window.goOnWithRun();
  ASSERT_TRUE(window.controller().waitFor(patience));
  EXPECT_FALSE(window.messages()->text().isEmpty());
  EXPECT_EQ(window.store().rowCount(), 0);
}

}  // namespace
}  // namespace squat::studio
