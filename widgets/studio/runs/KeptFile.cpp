#include "studio/runs/KeptFile.h"

#include <QDir>
#include <QFileInfo>

#include "results/ResultFile.h"

namespace squat::studio {

// With its folder, once that is empty.
KeptFile::~KeptFile() {
  if (path_.isEmpty()) return;
  QFile::remove(path_);
  QDir().rmdir(QFileInfo(path_).path());
}

void keepResult(const QString& file, const results::RunResult& result) {
  if (file.isEmpty() || !result.complete) return;
  try {
    results::writeResult(file.toStdString(), result);
  } catch (const std::exception&) {
    // The disk is full, or memory is: the run's checkpoint stays then.
  }
}

}  // namespace squat::studio
