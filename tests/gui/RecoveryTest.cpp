// Work that is in no project of the user's, after a crash.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <QAction>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include "case/CaseFile.h"
#include "core/platform/Process.h"
#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "results/SignalTable.h"
#include "studio/common/MessageBar.h"
#include "studio/document/CaseDocument.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/runs/StoppedRuns.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

// A window over one folder of untitled projects.
class Recovery : public testing::Test {
 protected:
  std::unique_ptr<MainWindow> open(Answer answer = Answer::discard) {
    StudioServices services = tests::services(50, answer);
    services.recoveryFolder = recovery();
    services.runsFolder = folder_.filePath("runs");
    auto window = std::make_unique<MainWindow>(services);
    return window;
  }
  QString recovery() const { return folder_.filePath("recovery"); }
  QStringList projects() const { return QDir(recovery()).entryList({"untitled-*"}, QDir::Dirs); }
  QStringList results() const {
    QStringList found;
    QDirIterator files(recovery(), {"*.h5"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) found << files.next();
    return found;
  }
  // Leaves the folder as a process that is killed does.
  void crash(std::unique_ptr<MainWindow> window) {
    const QString aside = folder_.filePath("aside");
    ASSERT_EQ(QProcess::execute("cp", {"-r", recovery(), aside}), 0);
    window.reset();
    ASSERT_TRUE(QDir(recovery()).removeRecursively());
    ASSERT_TRUE(QDir().rename(aside, recovery()));
  }
  // A window that is killed after so many runs.
  void crashAfterRuns(int runs) {
    auto window = open();
    window->openCase("light-defect");
    for (int i = 0; i < runs; ++i) {
      window->startRun();
      ASSERT_TRUE(window->controller().waitFor(60000));
    }
    window->keeper()->saveNow();
    crash(std::move(window));
  }
  QTemporaryDir folder_;
};

// All results of the window are read.
bool isRead(MainWindow& window) { return window.reader()->waitFor(60000); }

TEST_F(Recovery, allOfTheWorkIsThereAfterACrash) {
  const QString measured = folder_.filePath("measured.csv"), record = folder_.filePath("ride.csv");
  results::writeSignalTable(measured.toStdString(), tests::syntheticResult());
  auto window = open();
  window->openCase("light-defect");
  window->document().setParameter("motion.speed", "21");
  window->startRun();
  ASSERT_TRUE(window->controller().waitFor(60000));
  window->store().rename(0, "the first one");
  window->document().setParameter("motion.speed", "22");
  window->startRun();
  ASSERT_TRUE(window->controller().waitFor(60000));
  ASSERT_TRUE(window->openMeasured(measured));
  window->notes()->insertPlainText("Pads of the second bogie?");
  project::LongRecords records;
  records.files = {record.toStdString()};
  records.speed = 25;
  window->tool("squats");
  qobject_cast<DetectionForm*>(window->tool("squats")->form())->setChoices(records);
  window->keeper()->saveNow();
  crash(std::move(window));

  window = open();
  ASSERT_TRUE(isRead(*window));
  EXPECT_EQ(window->document().description().motion.speed, 22);
  EXPECT_TRUE(window->document().isModified());
  ASSERT_EQ(window->store().rowCount(), 3);
  EXPECT_EQ(window->store().at(0).label, "the first one");
  EXPECT_EQ(window->store().at(0).result->time, tests::syntheticResult().time);
  EXPECT_EQ(window->store().current(), 1);
  EXPECT_TRUE(window->store().at(2).isMeasured() && window->store().at(2).overlaid);
  EXPECT_EQ(window->notes()->toPlainText(), "Pads of the second bogie?");
  const auto shown = qobject_cast<DetectionForm*>(window->tool("squats")->form())->choices();
  EXPECT_EQ(shown.files, records.files);
  EXPECT_EQ(shown.speed, 25);
  EXPECT_TRUE(window->messages()->text().contains("was recovered")) << window->messages()->text().toStdString();
  // Nothing of it is saved yet: closing the window asks, and the next crash loses nothing.
  EXPECT_EQ(window->store().unsaved().size(), 2U);
  EXPECT_TRUE(window->notes()->document()->isModified());
  crash(std::move(window));
  window = open();
  ASSERT_TRUE(isRead(*window));
  EXPECT_EQ(window->store().unsaved().size(), 2U);
}

TEST_F(Recovery, whatIsLetGoInOrderLeavesNothing) {
  auto window = open(Answer::discard);
  window->openCase("light-defect");
  window->startRun();
  ASSERT_TRUE(window->controller().waitFor(60000));
  window->notes()->insertPlainText("not worth keeping");
  window->keeper()->saveNow();
  ASSERT_EQ(results().size(), 1);
  ASSERT_EQ(projects().size(), 1);
  ASSERT_TRUE(window->close());
  window.reset();
  EXPECT_EQ(projects().join(' '), "");
}

TEST_F(Recovery, whereNothingWouldBeMissedNothingIsSaidOfIt) {
  auto window = open();
  window->keeper()->saveNow();
  crash(std::move(window));
  window = open();
  EXPECT_EQ(window->messages()->text(), "");
  EXPECT_EQ(projects().size(), 1);  // of this window
}

// Fields are the larger part of a file; they are not read before they are looked at.
TEST_F(Recovery, aRecoveredResultIsSavedWhole) {
  ASSERT_NO_FATAL_FAILURE(crashAfterRuns(2));
  auto window = open();
  ASSERT_TRUE(isRead(*window));
  const QString path = folder_.filePath("work.squat-project");
  ASSERT_TRUE(window->saveProjectTo(path));
  EXPECT_EQ(window->store().unsaved().size(), 0U);
  for (int row = 0; row < 2; ++row) {
    const auto saved = results::readResult(window->store().at(row).path.toStdString());
    EXPECT_EQ(saved.snapshots.size(), tests::syntheticResult().snapshots.size()) << row;
    EXPECT_EQ(saved.patches.size(), tests::syntheticResult().patches.size()) << row;
    EXPECT_TRUE(window->store().at(row).path.startsWith(folder_.filePath("work-runs")));
  }
  EXPECT_EQ(results().join(' '), "");
  crash(std::move(window));
  EXPECT_EQ(open()->store().rowCount(), 0);  // it is in the project
}

TEST_F(Recovery, aResultIsSpokenOfUntilItIsSavedOrLetGo) {
  for (const bool save : {false, true}) {
    ASSERT_NO_FATAL_FAILURE(crashAfterRuns(1));
    const auto window = open();
    ASSERT_TRUE(isRead(*window));
    ASSERT_EQ(window->store().rowCount(), 1);
    ASSERT_TRUE(window->openCase("smooth-rail"));
    EXPECT_TRUE(window->messages()->text().contains("was recovered")) << window->messages()->text().toStdString();
    if (save)
      window->saveResultTo(0, folder_.filePath("saved.h5"));
    else
      window->store().remove(0);
    EXPECT_EQ(window->messages()->text(), "");
    EXPECT_EQ(results().join(' '), "");
  }
}

TEST_F(Recovery, aCaseIsSeenAsAnOpenedOne) {
  auto window = open();
  window->document().setParameter("defect.length", "90");
  window->keeper()->saveNow();
  crash(std::move(window));
  window = open();
  const QCPAxis& axis = *window->profile()->plot()->xAxis;
  const QCPRange before = axis.range();
  window->profile()->plot()->fit();
  EXPECT_DOUBLE_EQ(before.lower, axis.range().lower);
  EXPECT_DOUBLE_EQ(before.upper, axis.range().upper);
  window->findChild<QAction*>("new")->trigger();  // discards it
  EXPECT_EQ(window->messages()->text(), "");
}

// A run-up of 9 m does not fit the track: the user was about to mend it.
TEST_F(Recovery, aCaseThatIsBeingMendedIsKept) {
  auto window = open();
  window->document().setParameter("motion.run_up", "9");
  ASSERT_FALSE(window->document().validation().problems.empty());
  window->keeper()->saveNow();
  crash(std::move(window));
  EXPECT_EQ(open()->document().description().motion.runUp, 9);
}

TEST_F(Recovery, workOfALivingWindowIsLeftToIt) {
  auto first = open();
  first->document().setParameter("motion.speed", "21");
  first->keeper()->saveNow();
  const auto second = open();
  EXPECT_NE(second->document().description().motion.speed, 21);
  EXPECT_EQ(projects().size(), 2);
}

TEST_F(Recovery, workOfTwoWindowsComesBackOneAfterTheOther) {
  auto first = open(), second = open();
  first->document().setParameter("motion.speed", "21");
  second->document().setParameter("motion.speed", "22");
  first->keeper()->saveNow();
  second->keeper()->saveNow();
  const QString aside = folder_.filePath("aside");
  ASSERT_EQ(QProcess::execute("cp", {"-r", recovery(), aside}), 0);
  first.reset(), second.reset();
  ASSERT_TRUE(QDir(recovery()).removeRecursively() && QDir().rename(aside, recovery()));
  const auto third = open();
  EXPECT_TRUE(third->messages()->text().contains("another window")) << third->messages()->text().toStdString();
  const auto fourth = open();
  EXPECT_EQ(third->document().description().motion.speed + fourth->document().description().motion.speed, 43);
}

// From a newer version, say: it is reported once, and stays.
TEST_F(Recovery, whatCannotBeReadIsPutAside) {
  ASSERT_TRUE(QDir().mkpath(recovery() + "/untitled-1"));
  QFile broken(recovery() + "/untitled-1/untitled.squat-project");
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("no project");
  broken.close();
  auto window = open();
  window->openCase("light-defect");  // hides the message
  EXPECT_TRUE(tests::passes([&] { return window->messages()->text().contains("is kept as"); }));
  window.reset();
  EXPECT_EQ(open()->messages()->text(), "");
  EXPECT_TRUE(QFile::exists(recovery() + "/untitled-1/untitled.squat-project.unreadable"));
}

TEST_F(Recovery, aResultThatCannotBeReadStays) {
  ASSERT_NO_FATAL_FAILURE(crashAfterRuns(1));
  QFile broken(results().value(0));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("no result");
  broken.close();
  auto window = open();
  ASSERT_TRUE(isRead(*window));
  EXPECT_TRUE(window->store().at(0).isMissing());
  window->store().remove(0);
  ASSERT_TRUE(window->close());
  window.reset();
  EXPECT_EQ(results().size(), 1);
}

// A full disk, or here a file where the folder should be: the run can resume from its checkpoint; a message says so.
TEST_F(Recovery, aResultThatCannotBeWrittenKeepsItsCheckpoint) {
  auto window = open();
  window->openCase("light-defect");
  QFile inTheWay(recovery() + "/untitled-1/untitled-runs");
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  inTheWay.close();
  window->startRun();
  const QString checkpoint = StoppedRuns(folder_.filePath("runs")).file(window->document().description());
  QFile file(checkpoint);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.close();
  ASSERT_TRUE(window->controller().waitFor(60000));
  EXPECT_TRUE(StoppedRuns::exists(checkpoint));
  EXPECT_TRUE(window->messages()->text().contains("could not be written")) << window->messages()->text().toStdString();
  ASSERT_TRUE(window->saveResultTo(0, folder_.filePath("saved.h5")));
  EXPECT_FALSE(StoppedRuns::exists(checkpoint));  // nothing is left to resume
}

// A project that is made while a run is under way gets its result as well.
TEST_F(Recovery, theResultOfARunGoesIntoTheProjectThatWasMadeMeanwhile) {
  auto window = open();
  window->openCase("light-defect");
  window->startRun();
  ASSERT_TRUE(window->saveProjectTo(folder_.filePath("work.squat-project")));
  ASSERT_TRUE(window->controller().waitFor(60000));
  EXPECT_TRUE(window->store().at(0).path.startsWith(folder_.filePath("work-runs")));
  EXPECT_EQ(results().join(' '), "");
}

// Also of somebody who types without a pause.
TEST_F(Recovery, noChangeWaitsLongerThanFiveSeconds) {
  const auto window = open();
  const QString file = recovery() + "/untitled-1/untitled.squat-project";
  QElapsedTimer since;
  since.start();
  while (!QFile::exists(file) && since.elapsed() < 10000) {
    window->notes()->insertPlainText("x");
    QTest::qWait(50);
  }
  EXPECT_LT(since.elapsed(), 5000);
}

constexpr const char* deadProcess = "999999999";  // above the largest number of a process

// Release 0.3.0 kept a copy of the case and each result by itself.
TEST_F(Recovery, whatEarlierReleasesLeftIsTaken) {
  ASSERT_TRUE(QDir().mkpath(recovery()));
  const QString left = recovery() + '/' + deadProcess + "-1-00000000";
  CaseDocument document;
  document.setParameter("motion.speed", "21");
  QFile kept(left + ".case");
  ASSERT_TRUE(kept.open(QIODevice::WriteOnly));
  kept.write("# dip\n" + QByteArray::fromStdString(cases::writeCase(document.description())));
  kept.close();
  results::writeResult((left + "-1 run.h5").toStdString(), tests::syntheticResult());
  QFile broken(recovery() + '/' + deadProcess + "-2-00000000.case");
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("# x\nnot = [a case");
  broken.close();
  auto window = open();
  ASSERT_TRUE(isRead(*window));
  EXPECT_EQ(window->document().name(), "dip");
  EXPECT_EQ(window->document().description().motion.speed, 21);
  ASSERT_EQ(window->store().unsaved().size(), 1U);
  EXPECT_EQ(window->store().at(0).label, "run");
  EXPECT_EQ(QDir(recovery()).entryList(QDir::Files).size(), 1);  // the one that is no case
  crash(std::move(window));
  window = open();
  ASSERT_TRUE(isRead(*window));
  EXPECT_EQ(window->store().unsaved().size(), 1U);
}

QByteArray firstLine(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readLine() : QByteArray();
}

// A process that has ended stands in the table of processes until the one that started it asks: it runs no more.
TEST(ProcessIdentity, ofAProcessThatHasEndedIsNotAlive) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    char byte = 0;
    ::close(pipe[1]);
    [[maybe_unused]] const auto waited = ::read(pipe[0], &byte, 1);
    ::_exit(0);
  }
  ASSERT_GT(child, 0);
  const QString stat = QStringLiteral("/proc/%1/stat").arg(child);
  const auto fields = firstLine(stat).split(' ');
  const QString boot = firstLine("/proc/sys/kernel/random/boot_id").left(8);
  const QString identity = QStringLiteral("%1-%2-%3").arg(child).arg(QString(fields.value(21)), boot);
  EXPECT_TRUE(platform::isAlive(identity.toStdString()));
  EXPECT_FALSE(
      platform::isAlive(QStringLiteral("%1-1-%2").arg(child).arg(boot).toStdString()));  // another one had this number
  ::close(pipe[0]), ::close(pipe[1]);
  EXPECT_TRUE(tests::passes([&] { return firstLine(stat).contains(") Z "); }));
  EXPECT_FALSE(platform::isAlive(identity.toStdString()));
  ::waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace squat::studio
