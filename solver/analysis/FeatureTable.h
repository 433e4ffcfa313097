// solver/analysis/FeatureTable.h - the features of a run, under one set of names for tables of studies, answers to
// other programs, result files and reports.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/RunResult.h"

namespace squat::analysis {

// Columns with their units ("peak [m/s2]") and values: signals::featureRow of runFeatures, and the extremes of the
// contact force; of a whole model those of the right side behind them. Throws SignalError where the record is too
// short.
std::vector<std::pair<std::string, double>> featureTable(const results::RunResult& result);

// Name of a feature in one word, without its unit: "peak_1_frequency" for "peak 1 frequency [Hz]".
std::string featureWord(const std::string& column);

// What a feature is called where people read it, without its unit, whether the name is that of a column or of
// featureWord: "Largest acceleration, up or down" for "peak [m/s2]", "Power, 200-400 Hz" for "power_200-400_Hz". A name
// that no feature has comes back with blanks for its underscores.
std::string featureTitle(const std::string& name);

// The same features as a result holds them: in one word, with unit and description. None where the record is too short.
std::vector<results::Scalar> featureScalars(const results::RunResult& result);

}  // namespace squat::analysis
