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
  connect(&copying_, &BackgroundJob::news, this,
          [this](const WorkerMonitor::News& news) { Q_EMIT copyProgressed(news.progress.fraction); });
  connect(&copying_, &BackgroundJob::ended, this, &ProjectKeeper::concludeCopy);
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
  Q_EMIT openChanged(true);
  return true;
}

void ProjectKeeper::release() {
  timer_.stop();
  path_.clear();
  lock_.reset();
  Q_EMIT openChanged(false);
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

void ProjectKeeper::copyTo(const QString& path) {
  if (isCopying()) return;
  copyPath_ = QFileInfo(path).absoluteFilePath();
  if (copyPath_ == path_)
    throw FileError(path.toStdString(), "", "is the project that is open", "Choose another name for the copy");
  saveNow();
  copy_ = std::make_shared<project::ProjectCopy>();
  copying_.start([copy = copy_, project = collect_(), to = copyPath_.toStdString()](Monitor& monitor) {
    *copy = project::copyWithData(project, to, monitor);
  });
}

void ProjectKeeper::concludeCopy(const std::exception_ptr& error) {
  const QString folder = QString::fromStdString(project::dataFolder(copyPath_.toStdString()));
  if (error) try {
      std::rethrow_exception(error);
    } catch (const std::exception& failure) {
      Q_EMIT failed(tr("The project was not copied. %1").arg(QString::fromStdString(failure.what())));
      Q_EMIT copyEnded({}, {});
      return;
    }
  QStringList problems;
  for (const auto& problem : copy_->problems) problems << QString::fromStdString(problem);
  if (!copy_->complete)
    Q_EMIT copyEnded(tr("The copy was cancelled; nothing of it is left."), {});
  else
    Q_EMIT copyEnded(tr("The project was copied to %1, %2 files of its data to %3.")
                         .arg(copyPath_)
                         .arg(copy_->files)
                         .arg(QFileInfo(folder).fileName()),
                     problems);
}

}  // namespace squat::studio
