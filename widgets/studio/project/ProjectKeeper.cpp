#include "studio/project/ProjectKeeper.h"

#include <QDir>
#include <QFileInfo>

#include "core/Errors.h"
#include "project/ProjectFile.h"

namespace squat::studio {
ProjectKeeper::ProjectKeeper(std::function<project::Project()> collect, QObject* parent)
    : QObject(parent), collect_(std::move(collect)) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] {
    try {
      saveNow();
    } catch (const FileError& error) {
      Q_EMIT failed(QString::fromStdString(error.what()));
    }
  });
}

QString ProjectKeeper::name() const { return QFileInfo(path_).completeBaseName(); }

bool ProjectKeeper::take(const QString& path, QString* other) {
  const QFileInfo file(path);
  const QString whole = file.absoluteFilePath();
  if (whole == path_) return true;
  const QString beside = file.absoluteDir().filePath("." + file.fileName() + ".lock");
  auto lock = std::make_unique<FileLock>(beside.toStdString());
  if (lock->isTaken()) {
    *other = QString::fromStdString(lock->other()).trimmed();
    return false;
  }
  lock->write(processName("squat-studio"));
  lock_ = std::move(lock);
  path_ = whole;
  return true;
}

void ProjectKeeper::release() {
  timer_.stop();
  path_.clear();
  lock_.reset();
}

void ProjectKeeper::saveSoon(int delay) {
  if (isOpen() && (!timer_.isActive() || timer_.interval() > 0)) timer_.start(delay);
}

void ProjectKeeper::saveNow() {
  timer_.stop();
  if (isOpen()) project::writeProject(path_.toStdString(), collect_());
}

QString ProjectKeeper::nextResult(const QString& stem) const {
  const QDir folder(QFileInfo(path_).absoluteDir().filePath(name() + "-runs"));
  folder.mkpath(".");          // where that fails, so does the writing, and that is noticed
  constexpr int longest = 60;  // a letter may take three bytes of the 255 that a name has
  QString base = stem.left(longest);
  base.replace('/', '_');
  for (int number = 1;; ++number) {
    QString file = folder.filePath(number == 1 ? base + ".h5" : QStringLiteral("%1-%2.h5").arg(base).arg(number));
    if (!QFileInfo::exists(file)) return file;
  }
}

}  // namespace squat::studio
