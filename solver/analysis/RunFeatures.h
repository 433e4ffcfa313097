// solver/analysis/RunFeatures.h - the features of a record.
#pragma once

#include <string>

#include "signals/Features.h"
#include "signals/Record.h"

namespace squat::analysis {

// Of a channel of the record, anchored by signals::anchorOf: where the wheel centre passes the defect's deepest point,
// as the largest value may be a later swing of the ringing; in a record that ends before, the largest value.
// Throws SignalError where the record has no such channel or is too short.
signals::Features runFeatures(const signals::Record& record, const signals::FeatureOptions& options = {},
                              const std::string& channel = "aba_filtered");

}  // namespace squat::analysis
