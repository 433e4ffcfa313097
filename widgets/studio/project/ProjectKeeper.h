// widgets/studio/project/ProjectKeeper.h - the file of the open project: saved as the work goes on, owned by one
// window, copied with its data.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/FileLock.h"
#include "project/Project.h"
#include "project/ProjectCopy.h"
#include "studio/runs/BackgroundJob.h"

namespace squat::studio {

class ProjectKeeper : public QObject {
  Q_OBJECT
 public:
  // `collect` gives the work as it is now.
  explicit ProjectKeeper(std::function<project::Project()> collect, QObject* parent = nullptr);

  bool isOpen() const { return !path_.isEmpty(); }
  QString path() const { return path_; }  // absolute; empty: no project is open
  QString name() const;
  // The project is this file's from now on; nothing is written yet. False where another window has it open, which
  // `other` names.
  bool take(const QString& path, QString* other);
  void release();

  // Some time [ms] after the last of many changes; nothing without a project.
  void saveSoon(int delay = 2000);
  void saveNow();  // throws FileError

  // The next file for a result in the folder of the project's own results, which it makes: "DIR/DAY-runs/STEM-2.h5".
  QString nextResult(const QString& stem) const;

  // Saves the project, and copies it with its data (project/ProjectCopy.h) in a thread of its own; copyEnded() or
  // failed() follows. One copy at a time. Throws FileError.
  void copyTo(const QString& path);
  bool isCopying() const { return copying_.isRunning(); }
  void cancelCopy() { copying_.cancel(); }
  bool waitForCopy(int milliseconds) { return copying_.waitFor(milliseconds); }

 Q_SIGNALS:
  void failed(const QString& message);
  void openChanged(bool open);
  void copyProgressed(double fraction);
  // `said`: what was copied, or that it was cancelled; empty: it failed. `problems`: a sentence for each missing file.
  void copyEnded(const QString& said, const QStringList& problems);

 private:
  void concludeCopy(const std::exception_ptr& error);

  std::function<project::Project()> collect_;
  QString path_;
  std::unique_ptr<FileLock> lock_;
  QTimer timer_;
  QString copyPath_;
  std::shared_ptr<project::ProjectCopy> copy_;
  BackgroundJob copying_;  // the last one: its thread uses what stands above
};

}  // namespace squat::studio
