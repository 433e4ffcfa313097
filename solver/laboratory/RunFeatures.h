// solver/laboratory/RunFeatures.h - the features of a computed run.
#pragma once

#include "results/RunResult.h"
#include "signals/Features.h"

namespace squat::laboratory {

// Of a channel of the result, with the impact at the largest absolute value within `reach` of the defect's deepest
// point. Throws SignalError where the result has no such channel or is too short.
signals::Features runFeatures(const results::RunResult& result, signals::FeatureOptions options = {},
                              const std::string& channel = "aba_filtered", double reach = 0.15);

}  // namespace squat::laboratory
