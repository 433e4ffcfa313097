#include "laboratory/RunFeatures.h"

#include <cmath>

#include "signals/SignalError.h"

namespace squat::laboratory {

signals::Features runFeatures(const results::RunResult& result, signals::FeatureOptions options,
                              const std::string& channel, double reach) {
  const auto* values = result.signal(channel);
  if (!values) throw signals::SignalError("the result has no signal '" + channel + "'");
  if (values->size() != result.time.size() || values->size() != result.position.size() || values->size() < 2)
    throw signals::SignalError("signal '" + channel + "' has " + std::to_string(values->size()) +
                               " samples, which do not fit the time and position of the result");
  signals::TimeSeries series{result.time.front(),
                             (result.time.back() - result.time.front()) / static_cast<double>(values->size() - 1),
                             *values, channel, "m/s2"};
  for (const auto& entry : result.signals)
    if (entry.name == channel) series.unit = entry.unit;
  if (result.speed > 0) options.speed = result.speed;
  if (!options.impactTime) {
    std::optional<std::size_t> largest;
    for (std::size_t i = 0; i < values->size(); ++i)
      if (std::abs(result.position[i]) <= reach && (!largest || std::abs((*values)[i]) > std::abs((*values)[*largest])))
        largest = i;
    if (largest) options.impactTime = series.timeAt(*largest);
  }
  return signals::features(series, options);
}

}  // namespace squat::laboratory
