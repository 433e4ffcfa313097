// solver/analysis/FileComparison.h - a computed signal beside measured ones, or a defect beside its smooth run.
#pragma once

#include <string>
#include <vector>

#include "core/Monitor.h"
#include "readers/SignalFile.h"
#include "signals/Comparison.h"

namespace squat::analysis {

struct FileComparisonOptions {
  readers::SignalFileOptions first, second;  // how to read the first file, and the others
  double lowPass = 2000;                     // [Hz] both signals; 0: none
  signals::ComparisonOptions comparison;
  // The second is the same track's run without the defect: nothing is shifted, positions tell what belongs together.
  bool smooth = false;
};

struct FileComparison {
  std::string firstFile, secondFile;
  signals::Comparison comparison;
  std::vector<std::string> notes;
};

// A signal as it is compared: the axle box acceleration of a record that has several, else its first; with its
// positions, and low-passed where its rate allows it (0: as it is), else `notes` says so. Throws FileError, and
// CaseError where neither speed nor position is known.
signals::Passage comparedPassage(const signals::Record& signal, double lowPass, std::vector<std::string>& notes);

// The (only) signal of the first file with every run of the others. Throws FileError and CaseError.
std::vector<FileComparison> compareFiles(const std::string& first, const std::vector<std::string>& others,
                                         const FileComparisonOptions& options, Monitor& monitor);

}  // namespace squat::analysis
