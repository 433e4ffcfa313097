#include "laboratory/RunFeatures.h"

#include "signals/Alignment.h"
#include "signals/SignalError.h"

namespace squat::laboratory {

signals::Features runFeatures(const results::RunResult& result, signals::FeatureOptions options,
                              const std::string& channel) {
  const auto* values = result.signal(channel);
  if (!values) throw signals::SignalError("the result has no signal '" + channel + "'");
  if (values->size() != result.time.size() || values->size() != result.position.size() || values->size() < 2)
    throw signals::SignalError("signal '" + channel + "' has " + std::to_string(values->size()) +
                               " samples, but time or position of the result has another number");
  signals::TimeSeries series{result.time.front(),
                             (result.time.back() - result.time.front()) / static_cast<double>(values->size() - 1),
                             *values, channel, "m/s2"};
  for (const auto& entry : result.signals)
    if (entry.name == channel) series.unit = entry.unit;
  const signals::Passage passage{series, result.position};
  if (!options.anchor) options.anchor = signals::anchorOf(passage);
  // As measured signals have it: the wheel's own speed there, a little beside the nominal one under torque.
  if (const double speed = signals::speedAt(passage, options.anchor->time); speed > 0) options.speed = speed;
  return signals::features(series, options);
}

}  // namespace squat::laboratory
