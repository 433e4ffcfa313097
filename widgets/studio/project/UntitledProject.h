// widgets/studio/project/UntitledProject.h - a project that the program keeps for work that the user has not saved as
// one.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/platform/FileLock.h"
#include "project/Project.h"

namespace squat::studio {

// Whether there is anything in it that the user would miss.
bool holdsWork(const project::Project& work);

// The file of a result beside those of a project, in a folder that it makes: "DIR/NAME-runs/STEM-2.h5".
QString nextResultFile(const QString& projectFile, const QString& stem);

// A project in a folder of its own, FOLDER/untitled-3, with the results that are not saved. Its window holds a lock on
// it. A window that is closed removes it; the next window opens what a crash has left.
class UntitledProject {
 public:
  struct Left;

  static std::unique_ptr<UntitledProject> make(const QString& folder);  // null where the folder cannot be made
  static Left takeLeft(const QString& folder);
  ~UntitledProject();
  UntitledProject(const UntitledProject&) = delete;
  UntitledProject& operator=(const UntitledProject&) = delete;

  QString file() const;
  QString results() const;                   // folder of the results that are not saved
  void write(const project::Project& work);  // removes the file where the work holds nothing; throws FileError
  void clear();                              // the work is saved elsewhere, or discarded

 private:
  UntitledProject(const QString& folder, std::unique_ptr<platform::FileLock> lock);

  QString folder_;
  std::unique_ptr<platform::FileLock> lock_;
};

// The newest work that a window left which no longer runs; it belongs to this window now.
struct UntitledProject::Left {
  std::unique_ptr<UntitledProject> project;  // null: there is none
  project::Project work;
  QStringList problems;  // a sentence for each file that cannot be read; it is put aside
  int others = 0;        // left for the next window to open
};

}  // namespace squat::studio
