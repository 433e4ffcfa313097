// widgets/studio/project/UntitledProject.h - work that is in no project of the user's, kept as a project all the same.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/FileLock.h"
#include "project/Project.h"

namespace squat::studio {

// Whether there is anything in it that the user would miss.
bool holdsWork(const project::Project& work);

// The file of a result beside those of a project, in a folder that it makes: "DIR/NAME-runs/STEM-2.h5".
QString nextResultFile(const QString& projectFile, const QString& stem);

// A project in a folder of its own, FOLDER/untitled-3, with the results that are not saved. It is locked as long as its
// window is there. A window that ends in order takes it along; what a crash leaves is taken by the next window.
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
  void write(const project::Project& work);  // nothing stands there where nothing would be missed; throws FileError
  void clear();                              // the work is in another project now, or let go

 private:
  UntitledProject(const QString& folder, std::unique_ptr<FileLock> lock);

  QString folder_;
  std::unique_ptr<FileLock> lock_;
};

// What windows left that are no more: the newest work, now this window's.
struct UntitledProject::Left {
  std::unique_ptr<UntitledProject> project;  // null: there is none
  project::Project work;
  QStringList problems;  // a sentence for each file that cannot be read; it is put aside
  int others = 0;        // that wait for the next window
};

}  // namespace squat::studio
