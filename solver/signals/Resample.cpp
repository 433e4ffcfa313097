#include "signals/Resample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "signals/BesselI0.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

constexpr int lobes = 16;        // zero crossings of the sinc to each side
constexpr double beta = 8.0;     // Kaiser: side lobes 80 dB down
constexpr int tableSteps = 512;  // per lobe; linear between: error (pi/512)^2/8 = 5e-6
// Longer records are a wrong unit of time, and outgrow the memory.
constexpr double maximumSamples = 2e7;

// The windowed sinc at 0 .. lobes in steps of 1/tableSteps.
const std::vector<double>& kernelTable() {
  static const std::vector<double> table = [] {
    std::vector<double> values(static_cast<std::size_t>(lobes) * tableSteps + 2, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double u = static_cast<double>(i) / tableSteps;
      if (u >= lobes) continue;
      const double sinc = u == 0 ? 1.0 : std::sin(std::numbers::pi * u) / (std::numbers::pi * u);
      values[i] = sinc * besselI0(beta * std::sqrt(1 - u * u / (lobes * lobes))) / besselI0(beta);
    }
    return values;
  }();
  return table;
}

double kernel(double u) {
  u = std::abs(u) * tableSteps;
  const auto& table = kernelTable();
  const auto i = static_cast<std::size_t>(u);
  if (i + 1 >= table.size()) return 0.0;
  const double part = u - static_cast<double>(i);
  return table[i] + part * (table[i + 1] - table[i]);
}

}  // namespace

Interpolator::Interpolator(const TimeSeries& series, double bandwidth)
    : series_(series), bandwidth_(bandwidth), reach_(0) {
  requireUsable(series, 1, "interpolation");
  if (!(lobes / bandwidth < maximumSamples))
    throw SignalError("'" + series.name + "': the new step is far too long; check its unit");
  reach_ = static_cast<int>(std::ceil(lobes / bandwidth));
}

double Interpolator::operator()(double time) const {
  const double sampleAt = (time - series_.start) / series_.step;
  const auto last = static_cast<double>(series_.values.size() - 1);
  if (sampleAt <= -reach_) return series_.values.front();
  if (sampleAt >= last + reach_) return series_.values.back();
  const double centre = std::floor(sampleAt);
  double sum = 0, weights = 0;
  for (int k = -reach_ + 1; k <= reach_; ++k) {
    const double sample = centre + k;
    const double weight = kernel((sampleAt - sample) * bandwidth_);
    sum += weight * series_.values[static_cast<std::size_t>(std::clamp(sample, 0.0, last))];
    weights += weight;
  }
  return sum / weights;
}

TimeSeries resample(const TimeSeries& series, double step) {
  if (!(std::isfinite(step) && step > 0)) throw SignalError("the new sampling step must be a positive time");
  requireUsable(series, 2, "resampling");
  const Interpolator at(series, std::min(1.0, 0.9 * series.step / step + (step <= series.step ? 1.0 : 0.0)));
  TimeSeries result{series.start, step, {}, series.name, series.unit};
  const double length = series.step * static_cast<double>(series.values.size() - 1);
  if (!(length / step < maximumSamples))
    throw SignalError("'" + series.name + "' would have more than 2e7 samples at the new step");
  const auto count = static_cast<std::size_t>(std::floor(length / step * (1 + 1e-12) + 1e-9)) + 1;
  result.values.resize(count);
  for (std::size_t i = 0; i < count; ++i) result.values[i] = at(result.timeAt(i));
  return result;
}

std::vector<double> onEqualSteps(const std::vector<double>& time, const std::vector<double>& values, double start,
                                 double step, std::size_t count) {
  constexpr std::size_t points = 8;
  std::vector<double> result(count);
  std::size_t next = 0;  // the first sample behind the instant
  for (std::size_t k = 0; k < count; ++k) {
    const double at = start + step * static_cast<double>(k);
    while (next < time.size() && time[next] <= at) ++next;
    const std::size_t first = std::min(next > points / 2 ? next - points / 2 : 0, time.size() - points);
    for (std::size_t i = first; i < first + points; ++i) {  // Lagrange's form
      double weight = 1;
      for (std::size_t j = first; j < first + points; ++j)
        if (j != i) weight *= (at - time[j]) / (time[i] - time[j]);
      result[k] += weight * values[i];
    }
  }
  return result;
}

double interpolateLinear(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (x.empty()) return 0;
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

}  // namespace squat::signals
