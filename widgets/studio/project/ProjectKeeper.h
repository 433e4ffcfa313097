// widgets/studio/project/ProjectKeeper.h - the file of the open project, or of an untitled one: saved as the work goes
// on, owned by one window, copied with its data.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/platform/FileLock.h"
#include "project/Project.h"
#include "project/ProjectCopy.h"
#include "studio/project/UntitledProject.h"
#include "studio/runs/BackgroundJob.h"

namespace squat::studio {

class ProjectKeeper : public QObject {
  Q_OBJECT
 public:
  // What a crash left; it belongs to this window now.
  struct Recovered {
    std::optional<project::Project> work;
    QStringList problems;
    int others = 0;  // left for the next window to open
  };

  // `collect` gives the work as it is now. While the user has no project open, the work is kept in an untitled one
  // under the folder `untitled`; empty: it is not kept.
  ProjectKeeper(std::function<project::Project()> collect, QString untitled, QObject* parent = nullptr);
  Recovered recover();  // once, before anything is kept

  bool isOpen() const { return !path_.isEmpty(); }  // a project of the user's
  QString path() const { return path_; }            // of that one, absolute; empty: none is open
  QString untitledResults() const;                  // folder of the results that are not saved; empty: there is none
  QString name() const;
  // The project is this file's from now on; nothing is written yet. False where another window has it open, which
  // `other` names.
  bool take(const QString& path, QString* other);
  void release();       // the work goes on in the untitled one
  void dropUntitled();  // what is in it is saved elsewhere, or discarded
  void end();           // the window closes: nothing is saved after this

  // `delay` [ms] after the last change, at most four seconds after the first one that is not saved.
  void saveSoon(int delay = 2000);
  void saveNow();  // throws FileError

  // The next file for a result in the folder of the project's own results, which it makes: "DIR/DAY-runs/STEM-2.h5".
  // Empty where nothing is kept.
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
  std::unique_ptr<platform::FileLock> lock_;
  QString untitledFolder_;
  std::unique_ptr<UntitledProject> untitled_;  // null: none can be kept
  bool hasEnded_ = false;
  QTimer timer_;
  QElapsedTimer unsaved_;  // since the first change that is in no file
  QString copyPath_;
  std::shared_ptr<project::ProjectCopy> copy_;
  BackgroundJob copying_;  // the last one: its thread uses what stands above
};

}  // namespace squat::studio
