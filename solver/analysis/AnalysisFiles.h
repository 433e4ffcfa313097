// solver/analysis/AnalysisFiles.h - an analysis as tables: CSV for people and spreadsheets, JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "analysis/Analysis.h"

namespace squat::analysis {

// Features (signals::featureRow) by name, with the unit in it: signals of several units have rows of their own. NaN
// where a signal lacks one.
struct FeatureTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;  // of each signal, in the order of the names
};
FeatureTable featureTable(const Analysis& analysis);

// One row a signal: file, run, anchor, then the features.
std::string featureCsv(const Analysis& analysis);

// {"signals": [{file, run, anchor, features: {name: value}, bands: [...], peaks: [...], notes}], "dispersion": {...},
// "notes"}
std::string featureJson(const Analysis& analysis);

// frequency, density of the whole record, and (own frequency axis) density around the impact.
std::string spectrumCsv(const SignalAnalysis& signal);

// axis, mean, lowest, highest, then each run.
std::string alignedCsv(const signals::AlignedRuns& runs);

// Writes features.csv, features.json, RUN_spectrum.csv for each signal, and aligned_time.csv, aligned_position.csv
// where there are several runs. Everything is made before anything is written, each file durably. Returns the paths.
// Throws CaseError where a table would replace a file that was analysed.
std::vector<std::string> writeAnalysis(const Analysis& analysis, const std::string& folder);

// Name without characters that a file name should not have; distinct names stay distinct within one call of
// writeAnalysis by a number behind them.
std::string safeFileName(const std::string& name);

}  // namespace squat::analysis
