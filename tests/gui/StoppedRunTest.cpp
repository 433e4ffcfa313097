// A run that was stopped, or that ended with the program, is resumed when its case is open again.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
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

constexpr int steps = 1500;  // of the made-up run: one a millisecond

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
  static QPushButton& resume(MainWindow& window) { return *window.findChild<QPushButton*>("resumeRun"); }
  static QString log(MainWindow& window) {
    return window.findChild<RunPanel*>()->findChild<QPlainTextEdit*>()->toPlainText();
  }
  // F5, then Shift+F5 as soon as the run tells something.
  static void runAndCancel(MainWindow& window) {
    tests::press(window, Qt::Key_F5);
    ASSERT_TRUE(tests::passes([&] { return log(window).contains("begins"); }, tests::patience));
    tests::press(window, Qt::Key_F5, Qt::ShiftModifier);
    ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }, tests::patience));
  }
  // "0.checkpoint" to "8.checkpoint", the oldest first.
  QDir writeNine() const {
    const QDir folder(folder_.path());
    for (int i = 0; i < 9; ++i) {
      QFile file(folder.filePath(QString::number(i) + ".checkpoint"));
      EXPECT_TRUE(file.open(QIODevice::WriteOnly));
      EXPECT_TRUE(file.setFileTime(QDateTime(QDate(2020, 1, 1 + i), QTime(0, 0)), QFileDevice::FileModificationTime));
    }
    return folder;
  }
  static void write(const QString& path, const QByteArray& text) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  }
  static QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  QTemporaryDir folder_;
};

TEST_F(StoppedRun, isOfferedForItsOwnCaseOnly) {
  const auto window = open();
  EXPECT_FALSE(resume(*window).isEnabled());
  EXPECT_FALSE(window->findChild<QAction*>("resumeAction")->isEnabled());
  runAndCancel(*window);
  EXPECT_TRUE(resume(*window).isEnabled());
  window->document().setParameter("motion.speed", "25");
  EXPECT_FALSE(resume(*window).isEnabled());
  EXPECT_FALSE(window->findChild<QAction*>("resumeAction")->isEnabled());
  window->document().undoStack().undo();
  EXPECT_TRUE(resume(*window).isEnabled());
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
  EXPECT_TRUE(window.findChild<QAction*>("resumeAction")->isEnabled());
  answer = Answer::discard;
  window.startRun();
  EXPECT_TRUE(window.controller().isRunning());
}

TEST_F(StoppedRun, isResumedAndTakesThePlaceOfItsFirstPart) {
  const auto window = open();
  runAndCancel(*window);
  ASSERT_EQ(window->store().rowCount(), 1);
  tests::click(resume(*window));
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, tests::patience));
  EXPECT_FALSE(log(*window).contains("step 0")) << log(*window).toStdString();
  EXPECT_FALSE(resume(*window).isEnabled());
  ASSERT_TRUE(tests::passes([&] { return !window->controller().isRunning(); }, tests::patience));
  ASSERT_EQ(window->store().rowCount(), 1);
  EXPECT_TRUE(window->store().currentResult()->complete);
  EXPECT_FALSE(resume(*window).isEnabled());  // there is nothing left to do
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

TEST_F(StoppedRun, beginsAnewWhereThatIsWished) {
  const auto window = open();
  runAndCancel(*window);
  tests::press(*window, Qt::Key_F5);
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, tests::patience));
  EXPECT_TRUE(log(*window).contains("begins at step 0"));
  window->controller().cancel();
  ASSERT_TRUE(window->controller().waitFor(tests::patience));
}

TEST_F(StoppedRun, survivesTheEndOfTheProgram) {
  {
    const auto window = open();
    tests::press(*window, Qt::Key_F5);
    ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, tests::patience));
    EXPECT_TRUE(window->close());  // the question is answered: stop it
  }
  const auto window = open();
  EXPECT_TRUE(resume(*window).isEnabled());
  tests::press(*window, Qt::Key_F5, Qt::ControlModifier);
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins"); }, tests::patience));
  EXPECT_FALSE(log(*window).contains("step 0"));
  window->controller().cancel();
  ASSERT_TRUE(window->controller().waitFor(tests::patience));
}

TEST_F(StoppedRun, onlyTheNewestFewAreKept) {
  const QDir folder = writeNine();
  const StoppedRuns runs(folder_.path());
  EXPECT_EQ(folder.entryList(QDir::Files, QDir::Name),
            QStringList({"5.checkpoint", "6.checkpoint", "7.checkpoint", "8.checkpoint"}));
}

// The lock is that of an open file: to it, two windows of one process are as two processes.
TEST_F(StoppedRun, staysWhileItIsUnderWay) {
  const QDir folder = writeNine();
  const QString oldest = folder.filePath("0.checkpoint");
  auto held = StoppedRuns::hold(oldest);
  ASSERT_TRUE(held && held->held());
  EXPECT_EQ(StoppedRuns::hold(oldest), nullptr);
  EXPECT_TRUE(StoppedRuns::owner(oldest).contains("squat-studio")) << StoppedRuns::owner(oldest).toStdString();
  const StoppedRuns next(folder_.path());
  StoppedRuns::forget(oldest);
  EXPECT_TRUE(StoppedRuns::exists(oldest));
  EXPECT_EQ(folder.entryList({"*.checkpoint"}, QDir::Files).size(), 5);
  held.reset();
  EXPECT_TRUE(StoppedRuns::owner(oldest).isEmpty());
  StoppedRuns::forget(oldest);
  EXPECT_EQ(folder.entryList(QDir::Files, QDir::Name),
            QStringList({"5.checkpoint", "6.checkpoint", "7.checkpoint", "8.checkpoint"}));
}

// A process that is killed leaves the file, not the lock.
TEST_F(StoppedRun, ofAKilledProcessIsResumed) {
  const QString checkpoint = StoppedRuns(folder_.path()).file(open()->document().description());
  write(checkpoint, "77\n");
  write(checkpoint + ".lock", "squat-studio (process 1 on elsewhere)");
  const auto window = open(600000);
  EXPECT_FALSE(QFile::exists(checkpoint + ".lock"));
  ASSERT_TRUE(resume(*window).isEnabled());
  tests::click(resume(*window));
  ASSERT_TRUE(tests::passes([&] { return log(*window).contains("begins at step 77"); }, tests::patience));
  window->controller().cancel();
  ASSERT_TRUE(window->controller().waitFor(tests::patience));
}

// The same case is open twice: the second window does not touch what the first one writes.
TEST_F(StoppedRun, ofAnotherWindowIsNotOfferedWhileItIsUnderWay) {
  const auto first = open(600000);
  tests::press(*first, Qt::Key_F5);
  ASSERT_TRUE(tests::passes([&] { return log(*first).contains("begins"); }, tests::patience));
  const QString checkpoint = StoppedRuns(folder_.path()).file(first->document().description());
  write(checkpoint, "77\n");  // as the solver does from time to time
  const auto second = open(600000);
  EXPECT_FALSE(resume(*second).isEnabled());
  EXPECT_FALSE(second->findChild<QAction*>("resumeAction")->isEnabled());
  second->resumeRun();
  EXPECT_FALSE(second->controller().isRunning());
  EXPECT_TRUE(second->messages()->text().contains("nother window")) << second->messages()->text().toStdString();
  second->startRun();  // without a checkpoint, which is said
  ASSERT_TRUE(second->controller().isRunning());
  EXPECT_TRUE(second->messages()->text().contains("cannot be resumed")) << second->messages()->text().toStdString();
  second->controller().cancel();
  ASSERT_TRUE(second->controller().waitFor(tests::patience));
  EXPECT_EQ(contentOf(checkpoint), "77\n");
  EXPECT_FALSE(resume(*second).isEnabled());
  first->controller().cancel();
  ASSERT_TRUE(first->controller().waitFor(tests::patience));
  QEvent activation(QEvent::ActivationChange);  // the user turns to the second window
  QApplication::sendEvent(second.get(), &activation);
  EXPECT_TRUE(resume(*second).isEnabled());
}

TEST_F(StoppedRun, aCheckpointThatIsNoneIsReported) {
  StudioServices services = tests::services();
  services.runner = simulation::runCase;
  services.runsFolder = folder_.path();
  MainWindow window(services);
  window.openCase("light-defect");
  QFile file(StoppedRuns(folder_.path()).file(window.document().description()));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("not a checkpoint");
  file.close();
  window.resumeRun();
  ASSERT_TRUE(window.controller().waitFor(tests::patience));
  EXPECT_FALSE(window.messages()->text().isEmpty());
  EXPECT_EQ(window.store().rowCount(), 0);
}

}  // namespace
}  // namespace squat::studio
