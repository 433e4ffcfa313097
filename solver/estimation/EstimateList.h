// solver/estimation/EstimateList.h - estimates of many defects: a folder each, and one table of all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimation/Estimation.h"

namespace squat::estimation {

// What came out for one passage.
struct EstimateRow {
  std::string file;        // of the passage
  bool hasFailed = false;  // no event, no unit, no profile that can be run, ...
  std::string message;     // why, or the notes
  Interval depth, length;  // [m]
  double misfit = 0;       // root mean square of the differences over the noise
  double peak = 0;         // [m/s2] of the record
  int runs = 0;
};

// FOLDER/STEM of the passage's file.
std::string estimateFolder(const std::string& folder, const std::string& file);

// What an estimate follows from, as a short hash: case, options, and the passage's content. Throws FileError where the
// passage cannot be read.
std::string estimateKey(const EstimateDefinition& definition, const EstimateOptions& options);

// FOLDER/STEM/estimate.json, durable, with the key; after writeEstimate(), which writes it without one.
void writeRow(const std::string& folder, const EstimateRow& row, const std::string& key, const Estimate* estimate);

// Nothing where there is none, or one of another key or version. Throws FileError where it is damaged.
std::optional<EstimateRow> readRow(const std::string& folder, const std::string& file, const std::string& key);

EstimateRow rowOf(const std::string& file, const Estimate& estimate);

// FOLDER/estimates.csv: passage, state, depth and length with their ranges, misfit, peak, runs, message.
std::string estimatesFile(const std::string& folder);
std::string estimatesText(const std::vector<EstimateRow>& rows);

}  // namespace squat::estimation
