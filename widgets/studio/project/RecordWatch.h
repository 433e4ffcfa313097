// widgets/studio/project/RecordWatch.h - what the files of long records hold, for a project that keeps it.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "project/Project.h"

namespace squat::studio {

// Files are looked at (project/FileDigest.h) in a thread of its own: they may be on a slow disk. A digest stands for
// what a file held when it was last listed, opened with a project, or searched, which is what the list of events is of.
class RecordWatch : public QObject {
  Q_OBJECT
 public:
  explicit RecordWatch(QObject* parent = nullptr);
  ~RecordWatch() override;  // waits for the file that is being looked at

  // Of a project, in place of what was watched; changed() follows for each file that holds something else.
  void open(const project::LongRecords& kept);
  void follow(const std::vector<std::string>& files);  // these alone: looks at those that are new
  void lookAgain();
  // Of each file; empty: not known yet, or not to be read.
  std::vector<std::string> digestsOf(const std::vector<std::string>& files) const;

 Q_SIGNALS:
  void looked();  // a digest is another one
  void changed(const QString& problem);

 private:
  struct Known {
    std::string digest;
    bool isKept = false;  // by the project, and not compared yet
  };
  void look(const std::string& file);
  void take(const std::string& file, const std::string& digest);

  std::map<std::string, Known> known_;
  std::atomic<int> generation_{0};
  QThreadPool thread_;
};

}  // namespace squat::studio
