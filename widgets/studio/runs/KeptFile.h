// widgets/studio/runs/KeptFile.h - a result that the user has not saved yet, in a file of the program's own.
#pragma once

#include <QString>
#include <utility>

#include "results/RunResult.h"

namespace squat::studio {

// Removes the file at the end of its life: the result is saved elsewhere then, or discarded.
class KeptFile {
 public:
  explicit KeptFile(QString path) : path_(std::move(path)) {}
  ~KeptFile();
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;

  const QString& path() const { return path_; }                // empty: there is no file
  QString leave() { return std::exchange(path_, QString()); }  // the file stays; returns where it is

 private:
  QString path_;
};

// Writes a complete result; does nothing for any other. Throws nothing: where it cannot be written, there is no file.
void keepResult(const QString& file, const results::RunResult& result);

}  // namespace squat::studio
