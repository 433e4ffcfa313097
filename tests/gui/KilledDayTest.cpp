// A day's work (DayOfWork.cpp: an imported profile, ten runs, a rename, a window closed and opened again, a measured
// overlay, a calibration of two keys, a report, notes) whose program is killed during an eleventh run: everything is
// there again, byte for byte.
#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "gui/MadeUpRun.h"
#include "studio/common/MessageBar.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"

namespace squat::studio {
namespace {

constexpr int patience = 800000;  // [ms] for busy machines; below the time that the test has

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Names of files that do not hold what the inventory says.
QStringList changedFiles(const QTemporaryDir& folder) {
  QStringList changed;
  for (const QByteArray& line : contentOf(folder.filePath("state/inventory")).split('\n')) {
    if (line.isEmpty()) continue;
    const QString name = QString::fromUtf8(line.mid(line.indexOf(' ') + 1));
    const auto digest = QCryptographicHash::hash(contentOf(folder.filePath(name)), QCryptographicHash::Sha256).toHex();
    if (digest != line.left(line.indexOf(' '))) changed << name;
  }
  return changed;
}

TEST(KilledDay, comesBackByteForByte) {
  const QTemporaryDir folder;
  QProcess day;
  day.setProcessChannelMode(QProcess::MergedChannels);
  day.start(SQUAT_DAY_OF_WORK, {folder.path()});
  ASSERT_TRUE(day.waitForStarted());
  ASSERT_TRUE(tests::passes(
      [&] { return QFile::exists(folder.filePath("ready")) || day.state() == QProcess::NotRunning; }, patience));
  ASSERT_EQ(day.state(), QProcess::Running) << day.readAll().toStdString();
  ASSERT_EQ(::kill(static_cast<pid_t>(day.processId()), SIGKILL), 0);
  ASSERT_TRUE(day.waitForFinished(patience));
  ASSERT_EQ(day.exitStatus(), QProcess::CrashExit);
  // Twelve files at least: case, ten results, signal, calibration, report, project.
  EXPECT_GE(contentOf(folder.filePath("state/inventory")).count('\n'), 12);
  EXPECT_EQ(changedFiles(folder).join(", "), "");

  StudioServices services = tests::services();
  services.recoveryFolder = folder.filePath("state/recovery");
  services.runsFolder = folder.filePath("state/runs");
  MainWindow window(services);
  window.show();
  ASSERT_TRUE(window.openProject(folder.filePath("day.squat-project"))) << window.messages()->text().toStdString();
  ASSERT_TRUE(window.reader()->waitFor(patience));
  EXPECT_TRUE(window.messages()->isEmpty()) << window.messages()->text().toStdString();
  RunStore& store = window.store();
  ASSERT_EQ(store.rowCount(), 11);
  for (int row = 0; row < 10; ++row) EXPECT_TRUE(store.at(row).result && store.at(row).result->complete) << row;
  EXPECT_EQ(store.at(2).label, "the third one");
  EXPECT_EQ(store.at(9).label, "height scale 1.5");
  EXPECT_TRUE(store.at(10).isMeasured());
  EXPECT_TRUE(store.at(10).overlaid);
  EXPECT_EQ(window.notes()->toPlainText(), "Pads of the second bogie?\n");
  EXPECT_EQ(window.document().name(), "dip");
  EXPECT_DOUBLE_EQ(window.document().description().motion.beyond, 0.4);  // changed after it was saved
  EXPECT_TRUE(window.document().isModified());
  window.keeper()->saveNow();
  EXPECT_EQ(changedFiles(folder).join(", "), "");
}

}  // namespace
}  // namespace squat::studio
