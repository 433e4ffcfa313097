// app/commands/EstimateEach.h - squat estimate --each: many passages, each over a defect of its own.
#pragma once

#include <functional>
#include <string>

#include "commands/FigureSheets.h"
#include "estimation/EstimateList.h"

namespace squat::commands {

struct EachEstimate {
  estimation::EstimateDefinition definition;  // its files are the passages
  estimation::EstimateOptions options;
  std::string folder, partition;
  bool collect = false;
  FigureChoice figures = {};
};

// Estimates each passage into FOLDER/STEM; those that are known are not estimated again. Without a partition, or to
// collect, FOLDER/estimates.csv is written. Throws CaseError where two passages have one stem, FileError that names the
// missing ones where they cannot be collected. Exit code.
int estimateEach(const EachEstimate& each, Monitor& monitor);

}  // namespace squat::commands
