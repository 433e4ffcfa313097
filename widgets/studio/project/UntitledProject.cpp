#include "studio/project/UntitledProject.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

#include "core/Errors.h"
#include "core/platform/Process.h"
#include "project/ProjectFile.h"

namespace squat::studio {
namespace {

const QLatin1String folderStem("untitled-");
const QLatin1String fileName("untitled.squat-project");

QString fileIn(const QString& folder) { return QDir(folder).filePath(fileName); }

std::unique_ptr<platform::FileLock> lockOf(const QString& folder) {
  return std::make_unique<platform::FileLock>(QDir(folder).filePath("." + fileName + ".lock").toStdString());
}

// Those of running windows too; the one that was saved last comes first.
QStringList projectFolders(const QString& folder) {
  QStringList found;
  for (const QFileInfo& entry : QDir(folder).entryInfoList({folderStem + '*'}, QDir::Dirs | QDir::NoSymLinks))
    found << entry.filePath();
  const auto saved = [](const QString& of) { return QFileInfo(fileIn(of)).lastModified(); };
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return saved(a) > saved(b); });
  return found;
}

QString resultsFolder(const QString& projectFile) {
  const QFileInfo project(projectFile);
  return project.absoluteDir().filePath(project.completeBaseName() + "-runs");
}

// Out of the way, for whoever can read it. Returns where it is.
QString putAside(const QString& file) {
  const QString aside = file + ".unreadable";
  return QFile::rename(file, aside) ? aside : file;
}

}  // namespace

bool holdsWork(const project::Project& work) {
  return work.open.modified || !work.open.path.empty() || !work.cases.empty() || !work.entries.empty() ||
         !work.notes.empty() || !work.records.files.empty();
}

QString nextResultFile(const QString& projectFile, const QString& stem) {
  const QDir folder(resultsFolder(projectFile));
  folder.mkpath(".");          // where that fails, so does the writing, and that is noticed
  constexpr int longest = 60;  // a letter may take three bytes of the 255 that a name has
  QString base = stem.left(longest);
  if (!base.isEmpty() && base.back().isHighSurrogate()) base.chop(1);
  base.replace('/', '_');
  for (int number = 1;; ++number) {
    QString file = folder.filePath(number == 1 ? base + ".h5" : QStringLiteral("%1-%2.h5").arg(base).arg(number));
    if (!QFileInfo::exists(file)) return file;
  }
}

UntitledProject::UntitledProject(const QString& folder, std::unique_ptr<platform::FileLock> lock)
    : folder_(folder), lock_(std::move(lock)) {
  lock_->write(platform::processName("squat-studio"));
}

// A folder that still holds something stays: a result that could not be read, say.
UntitledProject::~UntitledProject() {
  clear();
  lock_.reset();
  QDir().rmdir(results());
  QDir().rmdir(folder_);
}

std::unique_ptr<UntitledProject> UntitledProject::make(const QString& folder) {
  if (!QDir().mkpath(folder)) return nullptr;
  constexpr int most = 10000;  // folders that can neither be made nor seen
  for (int number = 1; number <= most; ++number) {
    const QString own = QDir(folder).filePath(folderStem + QString::number(number));
    if (!QDir().mkdir(own)) continue;  // another window's
    auto lock = lockOf(own);
    if (!lock->isTaken()) return std::unique_ptr<UntitledProject>(new UntitledProject(own, std::move(lock)));
  }
  return nullptr;
}

UntitledProject::Left UntitledProject::takeLeft(const QString& folder) {
  Left left;
  for (const QString& each : projectFolders(folder)) {
    auto lock = lockOf(each);
    if (!lock->held()) continue;  // its window is there
    if (const QString file = fileIn(each); left.project && QFileInfo::exists(file)) {
      ++left.others;
      continue;
    }
    std::unique_ptr<UntitledProject> found(new UntitledProject(each, std::move(lock)));
    if (!QFileInfo::exists(found->file())) continue;  // its folder goes, unless there is something else in it
    try {
      left.work = project::readProject(found->file().toStdString());
      if (holdsWork(left.work)) left.project = std::move(found);
    } catch (const FileError& error) {
      left.problems << QObject::tr("%1 (the unsaved work is kept as %2)")
                           .arg(QString::fromStdString(error.what()), putAside(found->file()));
    }
  }
  return left;
}

QString UntitledProject::file() const { return fileIn(folder_); }

QString UntitledProject::results() const { return resultsFolder(file()); }

void UntitledProject::write(const project::Project& work) {
  if (holdsWork(work))
    project::writeProject(file().toStdString(), work);
  else
    clear();
}

void UntitledProject::clear() { QFile::remove(file()); }

}  // namespace squat::studio
