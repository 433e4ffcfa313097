// solver/laboratory/RunFeatures.h - the features of a computed run.
#pragma once

#include "results/RunResult.h"
#include "signals/Features.h"

namespace squat::laboratory {

// Of a channel of the result, anchored by signals::anchorOf: where the wheel centre passes the defect's deepest point,
// as the largest value may be a later swing of the ringing; in a record that ends before, the largest value.
// Throws SignalError where the result has no such channel or is too short.
signals::Features runFeatures(const results::RunResult& result, signals::FeatureOptions options = {},
                              const std::string& channel = "aba_filtered");

}  // namespace squat::laboratory
