#include "studio/runs/StoppedRuns.h"

#include <QDir>
#include <QFileInfo>

#include "case/CaseFile.h"
#include "core/platform/Process.h"
#include "results/Checkpoint.h"

namespace squat::studio {
namespace {

const QString checkpointEnding = QStringLiteral(".checkpoint"), lockEnding = QStringLiteral(".lock");
constexpr int maximumKept = 4;

}  // namespace

StoppedRuns::StoppedRuns(const QString& folder) {
  if (folder.isEmpty() || !QDir().mkpath(folder)) return;
  folder_ = folder;
  const QDir kept(folder_);
  const auto newestFirst = kept.entryInfoList({"*" + checkpointEnding}, QDir::Files, QDir::Time);
  for (int i = maximumKept; i < newestFirst.size(); ++i) forget(newestFirst[i].filePath());
  const auto locks = kept.entryInfoList({"*" + checkpointEnding + lockEnding}, QDir::Files);
  for (const QFileInfo& lock : locks) owner(lock.filePath().chopped(lockEnding.size()));  // those of the dead go
}

QString StoppedRuns::file(const cases::CaseDescription& description) const {
  return file(cases::caseHash(description));
}

QString StoppedRuns::file(const std::string& caseHash) const {
  if (folder_.isEmpty() || caseHash.empty()) return {};
  return QDir(folder_).filePath(QString::fromStdString(caseHash) + checkpointEnding);
}

bool StoppedRuns::has(const cases::CaseDescription& description) const {
  const QString checkpoint = file(description);
  return exists(checkpoint) && owner(checkpoint).isEmpty();
}

bool StoppedRuns::exists(const QString& file) {
  return !file.isEmpty() && (QFileInfo::exists(file) || QFileInfo::exists(file + ".previous"));
}

QDateTime StoppedRuns::time(const QString& file) {
  const QFileInfo state(file), previous(file + ".previous");
  return state.exists() ? state.lastModified() : previous.lastModified();
}

// Asked with every change of the case: without a run under way there is no lock to be opened.
QString StoppedRuns::owner(const QString& file) {
  if (file.isEmpty() || !QFileInfo::exists(file + lockEnding)) return {};
  platform::FileLock lock((file + lockEnding).toStdString());
  if (lock.held()) lock.write({});  // a process that died has left it: without its text it goes with this one
  return QString::fromStdString(lock.other());
}

std::unique_ptr<platform::FileLock> StoppedRuns::hold(const QString& file) {
  if (file.isEmpty()) return nullptr;
  auto lock = std::make_unique<platform::FileLock>((file + lockEnding).toStdString());
  if (lock->isTaken()) return nullptr;
  lock->write(platform::processName("squat-studio"));
  return lock;
}

void StoppedRuns::forget(const QString& file) {
  if (!exists(file)) return;
  if (const auto held = hold(file)) results::removeCheckpoint(file.toStdString());
}

}  // namespace squat::studio
