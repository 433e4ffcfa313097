#include "analysis/RunFeatures.h"

namespace squat::analysis {

signals::Features runFeatures(const signals::Record& record, const signals::FeatureOptions& options,
                              const std::string& channel) {
  return signals::features(signals::passageOf(record, channel), options);
}

}  // namespace squat::analysis
