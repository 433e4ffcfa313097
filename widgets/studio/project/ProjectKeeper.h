// widgets/studio/project/ProjectKeeper.h - the file of the open project: saved as the work goes on, owned by one
// window.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/FileLock.h"
#include "project/Project.h"

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

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  std::function<project::Project()> collect_;
  QString path_;
  std::unique_ptr<FileLock> lock_;
  QTimer timer_;
};

}  // namespace squat::studio
