// solver/growth/GrowthFiles.h - what growth writes.
//
//   STEM-growth.csv   a line for each stage; units in the names of the columns
//   STEM-growth.h5    heights of the running surface at each stage, what wear and flow have taken, all stages; SI units
//   STEM-grown.toml   the case with the surface of the last stage as its defect: squat run shows how a train feels it
#pragma once

#include <string>
#include <vector>

#include "growth/Grow.h"

namespace squat::growth {

// A column of the table of stages.
struct StageColumn {
  const char* name;  // in the CSV file: word and unit
  const char* path;  // in the HDF5 file, below /stages
  const char* unit;  // there
  double Stage::*value;
  double scale;  // from SI to the unit of the CSV file
};
const std::vector<StageColumn>& stageColumns();

std::string growthTable(const Growth& growth);
results::ArrayTree growthTree(const Growth& growth);
cases::CaseDescription grownCase(const Growth& growth);

// Paths that a call may write, the checkpoint among them.
std::vector<std::string> growthFiles(const std::string& folder, const std::string& stem);
struct ForecastFiles {
  std::string table, folder;  // STEM-forecast.csv; STEM-forecast, whose study.csv has the depths of each growth
};
ForecastFiles forecastFiles(const std::string& folder, const std::string& stem);
std::string growthCheckpoint(const std::string& folder, const std::string& stem);

// Paths of what was written. Throws FileError.
std::vector<std::string> writeGrowthFiles(const Growth& growth, const std::string& folder, const std::string& stem);

// A stage in a line of a log: "2.50 Mt  depth 0.130 mm  axle box 105 m/s2".
std::string stageLine(const Stage& stage);

// For people: depth, waves and strain at a handful of stages, and what they say.
std::string growthSummary(const Growth& growth, const GrowthOptions& options);

}  // namespace squat::growth
