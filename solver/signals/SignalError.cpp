#include "signals/SignalError.h"

#include <algorithm>
#include <cmath>

namespace squat::signals {
namespace {

std::string nameOf(const std::string& name) { return name.empty() ? "the signal" : "signal '" + name + "'"; }

}  // namespace

void requireFinite(const std::vector<double>& values, const std::string& name) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
  if (bad == values.end()) return;
  const auto sample = static_cast<std::size_t>(bad - values.begin());
  throw SignalError(nameOf(name) + ": sample " + std::to_string(sample) + " is not a finite number", sample);
}

void requireUsable(const TimeSeries& series, std::size_t minimum, const std::string& use) {
  if (!(std::isfinite(series.step) && series.step > 0))
    throw SignalError(nameOf(series.name) + ": the sampling step must be a positive number of seconds, not " +
                      std::to_string(series.step));
  if (series.values.size() < minimum)
    throw SignalError(nameOf(series.name) + " has " + std::to_string(series.values.size()) + " samples; " + use +
                      " needs at least " + std::to_string(minimum));
  requireFinite(series.values, series.name);
}

void requireVarying(const TimeSeries& series, const std::string& use) {
  const auto& values = series.values;
  if (std::any_of(values.begin(), values.end(), [&](double value) { return value != values.front(); })) return;
  throw SignalError(nameOf(series.name) + " is constant; " + use + " needs a signal that varies");
}

}  // namespace squat::signals
