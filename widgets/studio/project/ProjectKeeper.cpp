#include "studio/project/ProjectKeeper.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "core/Errors.h"
#include "core/platform/Process.h"
#include "project/ProjectFile.h"
#include "studio/project/EarlierRecovery.h"

namespace squat::studio {

ProjectKeeper::ProjectKeeper(std::function<project::Project()> collect, QString untitled, QObject* parent)
    : QObject(parent), collect_(std::move(collect)), untitledFolder_(std::move(untitled)) {
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

ProjectKeeper::Recovered ProjectKeeper::recover() {
  Recovered recovered;
  if (untitledFolder_.isEmpty()) return recovered;
  auto left = UntitledProject::takeLeft(untitledFolder_);
  recovered.problems = left.problems;
  recovered.others = left.others;
  if (left.project) {
    recovered.work = std::move(left.work);
    untitled_ = std::move(left.project);
  } else if ((untitled_ = UntitledProject::make(untitledFolder_))) {
    recovered.work = takeEarlierRecovery(untitledFolder_, untitled_->file(), collect_().open);
    if (recovered.work) untitled_->write(*recovered.work);
  } else {
    recovered.problems
        << tr("%1 cannot be written: work that you do not save is lost if the program ends unexpectedly.")
               .arg(untitledFolder_);
  }
  return recovered;
}

QString ProjectKeeper::untitledResults() const { return untitled_ ? untitled_->results() : QString(); }

QString ProjectKeeper::name() const { return QFileInfo(path_).completeBaseName(); }

bool ProjectKeeper::take(const QString& path, QString* other) {
  const QFileInfo file(path);
  const QString whole = file.absoluteFilePath();
  if (whole == path_) return true;
  const QString beside = file.absoluteDir().filePath("." + file.fileName() + ".lock");
  auto lock = std::make_unique<platform::FileLock>(beside.toStdString());
  if (lock->isTaken()) {
    *other = QString::fromStdString(lock->other()).trimmed();
    return false;
  }
  lock->write(platform::processName("squat-studio"));
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
  saveSoon();
}

void ProjectKeeper::dropUntitled() {
  if (untitled_) untitled_->clear();
}

void ProjectKeeper::end() {
  hasEnded_ = true;
  release();
  dropUntitled();
}

void ProjectKeeper::saveSoon(int delay) {
  if (hasEnded_ || (!isOpen() && !untitled_) || (timer_.isActive() && timer_.interval() == 0)) return;
  constexpr int longest = 4000;  // [ms]: what a crash may cost somebody who types without a pause
  if (!timer_.isActive()) unsaved_.start();
  timer_.start(std::clamp(longest - static_cast<int>(unsaved_.elapsed()), 0, delay));
}

void ProjectKeeper::saveNow() {
  timer_.stop();
  if (isOpen()) {
    project::writeProject(path_.toStdString(), collect_());
    dropUntitled();
  } else if (untitled_) {
    untitled_->write(collect_());
  }
}

QString ProjectKeeper::nextResult(const QString& stem) const {
  if (!isOpen() && !untitled_) return {};
  return nextResultFile(isOpen() ? path_ : untitled_->file(), stem);
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
