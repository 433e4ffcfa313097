// solver/analysis/RunFeatures.h - the features of a record.
#pragma once

#include <string>
#include <vector>

#include "signals/Features.h"
#include "signals/Record.h"
#include "signals/SignalCatalogue.h"

namespace squat::analysis {

// Of a channel of the record, anchored by signals::anchorOf: where the wheel centre passes the defect's deepest point,
// as the largest value may be a later swing of the ringing; in a record that ends before, the largest value.
// Throws SignalError where the record has no such channel or is too short.
signals::Features runFeatures(const signals::Record& record, const signals::FeatureOptions& options = {},
                              const std::string& channel = signals::names::axleBoxFiltered);

// What a list of runs shows of each, made in a few milliseconds: without wavelets. Zero and empty where the record does
// not hold it.
struct RunDigest {
  double peak = 0;            // [m/s2] largest absolute value of aba_filtered
  std::vector<double> lines;  // [Hz] named lines of its spectrum around the defect, the most prominent first
};
RunDigest runDigest(const signals::Record& record);

}  // namespace squat::analysis
