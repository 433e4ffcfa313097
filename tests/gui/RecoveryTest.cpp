// Unsaved changes after a crash.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "case/CaseFile.h"
#include "gui/MadeUpRun.h"
#include "studio/CaseDocument.h"
#include "studio/Recovery.h"

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

}  // namespace
}  // namespace squat::studio
