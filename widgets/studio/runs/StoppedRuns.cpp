#include "studio/runs/StoppedRuns.h"

#include <QDir>
#include <QFileInfo>

#include "case/CaseFile.h"
#include "results/Checkpoint.h"

namespace squat::studio {
namespace {

const QString ending = QStringLiteral(".checkpoint");
constexpr int maximumKept = 4;

}  // namespace

StoppedRuns::StoppedRuns(const QString& folder) {
  if (folder.isEmpty() || !QDir().mkpath(folder)) return;
  folder_ = folder;
  const auto newestFirst = QDir(folder_).entryInfoList({"*" + ending}, QDir::Files, QDir::Time);
  for (int i = maximumKept; i < newestFirst.size(); ++i) forget(newestFirst[i].filePath());
}

QString StoppedRuns::file(const cases::CaseDescription& description) const {
  return file(cases::caseHash(description));
}

QString StoppedRuns::file(const std::string& caseHash) const {
  if (folder_.isEmpty() || caseHash.empty()) return {};
  return QDir(folder_).filePath(QString::fromStdString(caseHash) + ending);
}

bool StoppedRuns::exists(const QString& file) {
  return !file.isEmpty() && (QFileInfo::exists(file) || QFileInfo::exists(file + ".previous"));
}

void StoppedRuns::forget(const QString& file) {
  if (!file.isEmpty()) results::removeCheckpoint(file.toStdString());
}

}  // namespace squat::studio
