// Fifty windows without a project, each killed at another moment of its work (UntitledWork.cpp). Runs and measured
// signals that are half a second old are recovered, of what is typed or set whatever is five seconds old.
#include <gtest/gtest.h>

#include <QDateTime>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>
#include <map>
#include <random>

#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "results/SignalTable.h"
#include "studio/common/MessageBar.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/RunReader.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

constexpr int rounds = 50;
constexpr int patience = 60000;               // [ms]
constexpr qint64 typing = 5000, saved = 500;  // [ms] the age from which it must be kept

// The last of each kind that was done before this time.
std::map<QString, int> doneBefore(const QString& log, qint64 time) {
  std::map<QString, int> last;
  QFile file(log);
  if (!file.open(QIODevice::ReadOnly)) return last;
  for (const QByteArray& line : file.readAll().split('\n')) {
    const auto words = line.split(' ');
    if (words.size() == 3 && words[0].toLongLong() <= time) last[words[1]] = words[2].toInt();
  }
  return last;
}

int valueOf(const std::map<QString, int>& done, const QString& what) {
  const auto found = done.find(what);
  return found == done.end() ? 0 : found->second;
}

class KilledUntitled : public testing::Test {
 protected:
  void SetUp() override {
    results::writeSignalTable(folder_.filePath("measured.csv").toStdString(), tests::syntheticResult());
  }
  // Returns when it was killed [ms]; 0: it did not run.
  qint64 killAfter(int milliseconds) {
    QProcess work;
    work.setProcessChannelMode(QProcess::ForwardedChannels);
    QFile::remove(log());
    work.start(SQUAT_UNTITLED_WORK, {folder_.path()});
    if (!work.waitForStarted() || !tests::passes([&] { return QFile(log()).size() > 0; }, patience)) return 0;
    tests::passes([&] { return work.state() == QProcess::NotRunning; }, milliseconds);
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (::kill(static_cast<pid_t>(work.processId()), SIGKILL) != 0) return 0;
    return work.waitForFinished(patience) ? now : 0;
  }
  QString log() const { return folder_.filePath("log"); }
  QTemporaryDir folder_;
};

TEST_F(KilledUntitled, worksOnFromWhereItWas) {
  std::mt19937 random(20261129);
  int withAll = 0;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    const qint64 killed = killAfter(static_cast<int>(random() % 8000));
    ASSERT_GT(killed, 0);
    const auto typed = doneBefore(log(), killed - typing), done = doneBefore(log(), killed - saved);
    StudioServices services = tests::services();
    services.recoveryFolder = folder_.filePath("recovery");
    services.runsFolder = folder_.filePath("runs");
    MainWindow window(services);
    ASSERT_TRUE(window.reader()->waitFor(patience));
    const auto runs = window.store().unsaved().size();
    EXPECT_GE(static_cast<int>(runs), valueOf(done, "run"));
    EXPECT_GE(window.notes()->toPlainText().trimmed().section(' ', -1).toInt(), valueOf(typed, "notes"));
    const double speed = 20 + 0.05 * valueOf(typed, "speed");  // it grows; it was written with six digits
    EXPECT_TRUE(valueOf(typed, "speed") == 0 || window.document().description().motion.speed > speed - 1e-6);
    const bool isMeasured = window.store().rowCount() > static_cast<int>(runs);
    EXPECT_TRUE(isMeasured || valueOf(done, "measured") == 0);
    const auto records = qobject_cast<DetectionForm*>(window.tool("squats")->form())->choices();
    EXPECT_TRUE(records.speed == 25 || valueOf(typed, "records") == 0);
    EXPECT_TRUE(window.messages()->text().contains("was recovered") || valueOf(typed, "notes") == 0);
    withAll += valueOf(typed, "records") > 0;
    EXPECT_TRUE(window.close());  // discards it
  }
  EXPECT_GT(withAll, rounds / 20);  // otherwise the moments were too early to mean anything
}

}  // namespace
}  // namespace squat::studio
