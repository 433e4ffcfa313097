#include "laboratory/RunFeatures.h"

#include <optional>

#include "signals/SignalError.h"

namespace squat::laboratory {

namespace {

// [s] when the wheel centre stands over the deepest point, between the samples before and after it.
std::optional<double> timeAtTheDefect(const results::RunResult& result) {
  for (std::size_t i = 1; i < result.position.size(); ++i) {
    const double before = result.position[i - 1], after = result.position[i];
    if (before <= 0 && after > 0)
      return result.time[i - 1] + (result.time[i] - result.time[i - 1]) * before / (before - after);
  }
  return std::nullopt;
}

}  // namespace

signals::Features runFeatures(const results::RunResult& result, signals::FeatureOptions options,
                              const std::string& channel) {
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
  if (!options.impactTime) options.impactTime = timeAtTheDefect(result);
  return signals::features(series, options);
}

}  // namespace squat::laboratory
