// widgets/studio/runs/KeptFile.h - a result that the user has not saved yet, in a file of the program's own.
#pragma once

#include <QString>
#include <utility>

#include "results/RunResult.h"

namespace squat::studio {

// The file is there as long as this is; it goes when the result is saved elsewhere or let go.
class KeptFile {
 public:
  explicit KeptFile(QString path) : path_(std::move(path)) {}
  ~KeptFile();
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;

  const QString& path() const { return path_; }                // empty: the program keeps no files
  QString leave() { return std::exchange(path_, QString()); }  // the file stays; returns where it is

 private:
  QString path_;
};

// Writes a complete result to a file of its own, any other not. Nothing is thrown: whether it could be written, the
// file tells.
void keepResult(const QString& file, const results::RunResult& result);

}  // namespace squat::studio
