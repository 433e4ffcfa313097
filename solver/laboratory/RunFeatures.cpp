#include "laboratory/RunFeatures.h"

namespace squat::laboratory {

signals::Features runFeatures(const signals::Record& record, const signals::FeatureOptions& options,
                              const std::string& channel) {
  return signals::features(signals::passageOf(record, channel), options);
}

}  // namespace squat::laboratory
