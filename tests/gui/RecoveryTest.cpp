// Unsaved changes after a crash.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <QAction>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "case/CaseFile.h"
#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "studio/common/MessageBar.h"
#include "studio/common/ProcessIdentity.h"
#include "studio/document/CaseDocument.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/runs/StoppedRuns.h"
#include "studio/window/Recovery.h"

namespace squat::studio {
namespace {

constexpr const char* deadProcess = "999999999";  // above the largest number of a process

TEST(Recovery, whatACrashLeftIsTaken) {
  const QTemporaryDir folder;
  CaseDocument document;
  document.setParameter("motion.speed", "21");
  {
    Recovery recovery(document, folder.path());
    recovery.saveNow();
    const auto files = QDir(folder.path()).entryList(QDir::Files);
    ASSERT_EQ(files.size(), 1);
    EXPECT_FALSE(Recovery::take(folder.path()));  // its process is alive: us
    QFile::copy(folder.filePath(files[0]), folder.filePath(QString(deadProcess) + ".case"));
  }
  const auto found = Recovery::take(folder.path());
  ASSERT_TRUE(found);
  EXPECT_TRUE(sameCase(found->description, document.description()));
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Recovery, savingTheCaseMakesTheCopyNeedless) {
  const QTemporaryDir folder;
  CaseDocument document;
  Recovery recovery(document, folder.path());
  document.setParameter("motion.speed", "21");
  recovery.saveNow();
  document.save(folder.filePath("case.toml"));
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList("case.toml"));
}

TEST(Recovery, brokenCopiesAreThrownAway) {
  const QTemporaryDir folder;
  QFile broken(folder.filePath(QString(deadProcess) + ".case"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("# x\nnot = [a case");
  broken.close();
  EXPECT_FALSE(Recovery::take(folder.path()));
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

// A run-up of 9 m does not fit the track: the user was about to mend it.
TEST(Recovery, aCaseThatIsBeingMendedIsKept) {
  const QTemporaryDir folder;
  CaseDocument document;
  document.setParameter("motion.run_up", "9");
  ASSERT_FALSE(document.validation().problems.empty());
  QFile kept(folder.filePath(QString(deadProcess) + ".case"));
  ASSERT_TRUE(kept.open(QIODevice::WriteOnly));
  kept.write("# x\n" + QByteArray::fromStdString(cases::writeCase(document.description())));
  kept.close();
  const auto found = Recovery::take(folder.path());
  ASSERT_TRUE(found);
  EXPECT_TRUE(sameCase(found->description, document.description()));
}

// Found, and the next crash comes before the next change.
TEST(Recovery, whatWasRecoveredIsKeptAtOnce) {
  const QTemporaryDir folder;
  CaseDocument document;
  document.setParameter("motion.speed", "21");
  QFile kept(folder.filePath(QString(deadProcess) + ".case"));
  ASSERT_TRUE(kept.open(QIODevice::WriteOnly));
  kept.write("# x\n" + QByteArray::fromStdString(cases::writeCase(document.description())));
  kept.close();
  StudioServices services = tests::services();
  services.recoveryFolder = folder.path();
  MainWindow window(services);
  EXPECT_EQ(window.document().description().motion.speed, 21);
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

TEST(Recovery, aRecoveredCaseIsSeenAsAnOpenedOne) {
  const QTemporaryDir folder;
  CaseDocument document;
  document.setParameter("defect.length", "90");
  QFile kept(folder.filePath(QString(deadProcess) + ".case"));
  ASSERT_TRUE(kept.open(QIODevice::WriteOnly));
  kept.write("# x\n" + QByteArray::fromStdString(cases::writeCase(document.description())));
  kept.close();
  StudioServices services = tests::services();
  services.recoveryFolder = folder.path();
  MainWindow window(services);
  const QCPRange seen = window.profile()->plot()->xAxis->range();
  window.profile()->plot()->fit();
  EXPECT_DOUBLE_EQ(seen.lower, window.profile()->plot()->xAxis->range().lower);
  EXPECT_DOUBLE_EQ(seen.upper, window.profile()->plot()->xAxis->range().upper);
  EXPECT_TRUE(window.messages()->text().contains("recovered"));
  window.findChild<QAction*>("new")->trigger();  // lets it go
  EXPECT_TRUE(window.messages()->text().isEmpty()) << window.messages()->text().toStdString();
}

// A number of a process comes back: a copy from before is told by its start, and offered although "its" process lives.
TEST(Recovery, aProcessOfTheSameNumberIsAnother) {
  const QTemporaryDir folder;
  CaseDocument document;
  document.setParameter("motion.speed", "21");
  Recovery recovery(document, folder.path());
  recovery.saveNow();
  const QString own = QDir(folder.path()).entryList(QDir::Files).value(0);
  ASSERT_TRUE(own.startsWith(QString::number(QCoreApplication::applicationPid()) + "-")) << own.toStdString();
  QFile::copy(folder.filePath(own), folder.filePath(own.section('-', 0, 0) + "-1-00000000.case"));
  EXPECT_TRUE(Recovery::take(folder.path()));
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList(own));
}

QByteArray firstLine(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readLine() : QByteArray();
}

// A process that has ended stands in the table of processes until the one that started it asks: it runs no more.
TEST(Recovery, aProcessThatHasEndedIsNotAlive) {
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
  const QString identity =
      QStringLiteral("%1-%2-%3").arg(child).arg(QString(fields.value(21)), ownIdentity().section('-', 2));
  EXPECT_TRUE(isAlive(identity));
  ::close(pipe[0]), ::close(pipe[1]);
  EXPECT_TRUE(tests::passes([&] { return firstLine(stat).contains(") Z "); }));
  EXPECT_FALSE(isAlive(identity));
  ::waitpid(child, nullptr, 0);
}

class UnsavedResult : public testing::Test {
 protected:
  std::unique_ptr<MainWindow> open(Answer answer = Answer::discard) {
    StudioServices services = tests::services(50, answer);
    services.recoveryFolder = folder_.filePath("recovery");
    services.runsFolder = folder_.filePath("runs");
    auto window = std::make_unique<MainWindow>(services);
    window->openCase("light-defect");
    return window;
  }
  QStringList kept() const { return QDir(folder_.filePath("recovery")).entryList({"*.h5"}, QDir::Files); }
  QTemporaryDir folder_;
};

// The crash: what this process has kept, as if another had.
TEST_F(UnsavedResult, isThereAgainAfterACrash) {
  const QDir recovery(folder_.filePath("recovery"));
  {
    const auto window = open();
    window->startRun();
    ASSERT_TRUE(window->controller().waitFor(60000));
    ASSERT_EQ(kept().size(), 1);
    QString other = kept()[0];
    other.replace(0, other.indexOf('-'), deadProcess);
    ASSERT_TRUE(QFile::copy(recovery.filePath(kept()[0]), recovery.filePath(other)));
  }
  ASSERT_EQ(kept().size(), 1);  // what the user let go in order is gone
  const auto window = open();
  ASSERT_EQ(window->store().rowCount(), 1);
  EXPECT_EQ(window->store().at(0).label, "light-defect (recovered)");
  EXPECT_EQ(window->store().unsaved().size(), 1U);
  EXPECT_EQ(window->store().at(0).result->time, tests::syntheticResult().time);
  EXPECT_EQ(kept().size(), 1);  // the next crash may come before it is saved
  ASSERT_TRUE(window->saveResultTo(0, folder_.filePath("saved.h5")));
  EXPECT_TRUE(kept().isEmpty());
}

TEST_F(UnsavedResult, isSpokenOfUntilItIsSavedOrLetGo) {
  for (const bool save : {false, true}) {
    ASSERT_TRUE(QDir().mkpath(folder_.filePath("recovery")));
    const QString left = folder_.filePath("recovery/") + deadProcess + "-1-00000000-1 run.h5";
    results::writeResult(left.toStdString(), tests::syntheticResult());
    const auto window = open();
    EXPECT_TRUE(tests::passes([&] { return window->messages()->text().contains("recovered"); }));
    ASSERT_EQ(window->store().rowCount(), 1);
    window->document().setParameter("motion.speed", "21");
    EXPECT_TRUE(window->messages()->text().contains("recovered"));
    if (save)
      window->saveResultTo(0, folder_.filePath("saved.h5"));
    else
      window->store().remove(0);
    EXPECT_TRUE(window->messages()->isHidden()) << window->messages()->text().toStdString();
  }
}

// A full disk, or here a file where the folder should be: the run can resume from its checkpoint; a message says so.
TEST_F(UnsavedResult, keepsItsCheckpointWhereItCannotBeWritten) {
  QFile inTheWay(folder_.filePath("recovery"));
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  inTheWay.close();
  const auto window = open();
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

// From a newer version, say: it is told once, and stays.
TEST_F(UnsavedResult, thatCannotBeReadIsPutAside) {
  ASSERT_TRUE(QDir().mkpath(folder_.filePath("recovery")));
  QFile broken(folder_.filePath("recovery/") + deadProcess + "-1 run.h5");
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("no result");
  broken.close();
  const auto first = open();
  EXPECT_EQ(first->store().rowCount(), 0);
  EXPECT_EQ(QDir(folder_.filePath("recovery")).entryList({"*.unreadable"}, QDir::Files).size(), 1);
  EXPECT_TRUE(first->messages()->isHidden());  // by the case that was opened; back as soon as anybody can see it
  EXPECT_TRUE(tests::passes([&] { return first->messages()->text().contains("is kept as"); }));
  const auto second = open();
  EXPECT_TRUE(second->messages()->text().isEmpty()) << second->messages()->text().toStdString();
}

}  // namespace
}  // namespace squat::studio
