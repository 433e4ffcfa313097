#include "studio/project/EarlierRecovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/platform/Process.h"
#include "studio/project/UntitledProject.h"

namespace squat::studio {
namespace {

// "PROCESS-START-BOOT.case": the first line is "# " and the name of the case, the rest the case file.
void takeCase(const QFileInfo& entry, project::Project& work) {
  QFile kept(entry.filePath());
  if (!kept.open(QIODevice::ReadOnly)) return;
  const std::string name = QString::fromUtf8(kept.readLine()).mid(2).trimmed().toStdString();
  const std::string text = kept.readAll().toStdString();
  try {
    cases::parseUnfinishedCase(text, name);
  } catch (const std::exception&) {
    return;
  }
  work.open = {name, {}, true, text};
  kept.remove();
}

// "PROCESS-START-BOOT-3 light-defect.h5"
void takeResult(const QFileInfo& entry, const QString& projectFile, project::Project& work) {
  const QString stem = entry.completeBaseName().section(' ', 1);
  project::Entry taken;
  const QString file = nextResultFile(projectFile, stem);
  if (!QFile::rename(entry.filePath(), file)) return;
  taken.path = file.toStdString();
  taken.name = stem.toStdString();
  work.entries.push_back(taken);
  work.current = static_cast<int>(work.entries.size()) - 1;
}

}  // namespace

std::optional<project::Project> takeEarlierRecovery(const QString& folder, const QString& projectFile,
                                                    const project::OpenCase& open) {
  project::Project work;
  const auto left = [&](const QString& ending, QDir::SortFlags order) {
    QFileInfoList found;
    for (const QFileInfo& entry : QDir(folder).entryInfoList({'*' + ending}, QDir::Files, order))
      if (!platform::isAlive(entry.completeBaseName().section(' ', 0, 0).section('-', 0, 2).toStdString()))
        found << entry;
    return found;
  };
  for (const QFileInfo& entry : left(".case", QDir::Time))
    if (work.open.toml.empty()) takeCase(entry, work);  // an older one waits for the next window
  for (const QFileInfo& entry : left(".h5", QDir::Time | QDir::Reversed)) takeResult(entry, projectFile, work);
  if (work.open.toml.empty()) work.open = open;
  if (!work.open.modified && work.entries.empty()) return std::nullopt;
  return work;
}

}  // namespace squat::studio
