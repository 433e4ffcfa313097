// widgets/studio/runs/UnsavedResults.h - results that the user has not saved yet survive a crash.
//
// A complete result is written to a file of the program's own before its checkpoint goes. That file goes when the
// result is saved or let go; what a crash leaves there is in the list of runs when the program starts again.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>

#include "results/RunResult.h"

namespace squat::studio {

// A file that is there as long as this is.
class KeptFile {
 public:
  explicit KeptFile(QString path) : path_(std::move(path)) {}
  ~KeptFile();
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;

 private:
  QString path_;
};

class UnsavedResults {
 public:
  explicit UnsavedResults(QString folder) : folder_(std::move(folder)) {}  // empty: nothing is kept

  // For the next result; empty where nothing is kept. Makes the folder where it can.
  QString nextFile(const QString& stem);
  static QString stemOf(const QString& file);
  // Writes a complete result there, any other not. Nothing is thrown: whether it could be written, the file tells.
  static void write(const QString& file, const results::RunResult& result);
  // What processes left that are no more, now files of this one.
  QStringList takeLeft();
  // Out of the way of takeLeft(), for whoever can read it. Returns where it is.
  static QString putAside(const QString& file);

 private:
  QString folder_;
  int made_ = 0;
};

}  // namespace squat::studio
