// widgets/studio/project/RunReader.h - reads the files of a project while the window is in use.
#pragma once

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <deque>

#include "project/Project.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

// All entries are listed at once, and their files are read in a thread of its own: the current run first, then what is
// overlaid and the reference, then the others. Results come without fields, which are most of a file. The fields of a
// run are read when it becomes the current one, and kept for the last few of them.
class RunReader : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t keptFields = 4;  // runs

  explicit RunReader(RunStore& store, QObject* parent = nullptr);
  ~RunReader() override;  // waits for the file that is being read

  // In place of all runs of the store. What was being read for another project is dropped. Results in the folder
  // `unsaved` are listed as not saved; their files are removed with them.
  void open(const project::Project& project, const QString& unsaved = {});
  // Result files and their names, after all runs there are; those that are listed already are left out.
  void add(const std::vector<std::pair<std::string, std::string>>& namedFiles);
  // The same of one file, which becomes the current run once it is read.
  void show(const std::string& file, const std::string& name);
  bool isBusy() const { return ahead_ > 0; }
  bool waitFor(int milliseconds);  // runs the event loop until all is read

  // With its fields, read here and now where they are not in memory. Throws FileError.
  ResultPointer wholeResult(int row);

 Q_SIGNALS:
  void progressed(int read, int all);
  void finished(const QStringList& problems);  // a sentence for each file that is missing or holds something else
  void failed(const QString& problem);         // the fields of the current run could not be read

 private:
  void ask(const RunLink& link, int generation);
  void take(const RunLink& link, StoredRun run, const QString& problem);
  void list();  // what has been read since
  void showWanted();
  void readFields();
  void takeFields(const RecordPointer& light, const ResultPointer& whole, const QString& problem);
  void setWhole(int row, const ResultPointer& whole);

  RunStore& store_;
  std::atomic<int> generation_{0};
  int ahead_ = 0, all_ = 0;
  QStringList problems_;
  std::string wanted_;               // file of the run that is to become the current one; empty: none
  RecordPointer asked_;              // the run whose fields are being read
  std::deque<RecordPointer> whole_;  // runs whose fields can be read again, the last one used first
  std::vector<std::pair<RunLink, StoredRun>> arrived_;
  QTimer timer_;
  QThreadPool thread_;
};

}  // namespace squat::studio
