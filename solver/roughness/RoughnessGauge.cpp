#include "roughness/RoughnessGauge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "signals/FourierTransform.h"
#include "signals/SignalError.h"
#include "signals/Window.h"

namespace squat::roughness {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double slowest = 1;          // [m/s]
constexpr double steadiness = 0.1;     // largest change of speed within a stretch, as a share
constexpr double highestShare = 0.45;  // of the sampling rate that a band may reach to
constexpr double weakest = 0.1;        // of the band's mean that the power of the response counts at least
constexpr std::size_t smallest = 64;   // samples of a stretch
constexpr double wavesInStretch = 8;

double squared(double value) { return value * value; }

// Mean of the response's power between two frequencies [1/s4].
double meanPower(const TransferFunction& transfer, double low, double high) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < transfer.frequency.size(); ++i)
    if (transfer.frequency[i] >= low && transfer.frequency[i] <= high) sum += std::norm(transfer.response[i]), ++count;
  return count > 0 ? sum / count : 0;
}

// What keeps an antiresonance from being divided by [1/s4].
double leastOf(double mean) { return std::max(1e-3 * mean, 1e-300); }

std::vector<double> levelWindow(std::size_t size) {
  std::vector<double> window(size, 1.0);
  const std::size_t edge = size / 20;
  for (std::size_t i = 0; i < edge; ++i)
    window[i] = window[size - 1 - i] =
        0.5 - 0.5 * std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(edge));
  return window;
}

}  // namespace

RoughnessGauge::RoughnessGauge(const TransferFunction& transfer, double rate, const GaugeOptions& options)
    : transfer_(transfer),
      rate_(rate),
      options_(options),
      bands_(wavelengthBands(options.shortest, options.longest)),
      sums_(bands_.size()) {
  for (const auto& band : corrugationBands()) gauges_.emplace_back(band);
}

void RoughnessGauge::setSize(double speed) {
  sizeSpeed_ = std::max(std::abs(speed), slowest);
  const double stretch = options_.stretch > 0 ? options_.stretch : wavesInStretch * options_.longest;
  const double samples = rate_ * stretch / sizeSpeed_;
  size_ = signals::fastLength(std::max(smallest, 2 * static_cast<std::size_t>(samples / 2)));
  size_ += size_ % 2;
}

// In pieces, each with stretches of a size for its speed: where that changes much, a new row of stretches begins.
void RoughnessGauge::add(const std::vector<double>& acceleration, const std::vector<double>& speed) {
  constexpr std::size_t piece = 16384;  // samples
  for (std::size_t from = 0; from < acceleration.size(); from += piece) {
    const auto first = static_cast<std::ptrdiff_t>(from);
    const auto last = static_cast<std::ptrdiff_t>(std::min(from + piece, acceleration.size()));
    const double own = std::max(std::abs(speed[static_cast<std::size_t>(first + (last - first) / 2)]), slowest);
    if (size_ > 0 && std::isfinite(own) && std::max(own / sizeSpeed_, sizeSpeed_ / own) > 1.5) breakHere();
    if (size_ == 0 && std::isfinite(own)) setSize(own);
    acceleration_.insert(acceleration_.end(), acceleration.begin() + first, acceleration.begin() + last);
    speed_.insert(speed_.end(), speed.begin() + first, speed.begin() + last);
    takeStretches(false);
  }
}

void RoughnessGauge::breakHere() {
  takeStretches(true);
  const double way = std::accumulate(speed_.begin(), speed_.end(), 0.0) / rate_;
  releaseHeights(heights_[0].size(), std::abs(way), {});
  for (auto& gauge : gauges_) gauge.skip(0);
  acceleration_.clear(), speed_.clear();
  size_ = 0, lastKnown_ = {};
}

// The bands whose frequencies at this speed lie within record and transfer function.
RoughnessGauge::PerBand RoughnessGauge::reachedBands(double speed) const {
  PerBand reached{};
  const double limit = std::min(transfer_.frequency.back(), highestShare * rate_);
  for (std::size_t b = 0; b < reached.size(); ++b) {
    const auto& band = corrugationBands()[b];
    reached[b] = speed / band.shortest <= limit && speed / band.longest >= transfer_.frequency.front();
  }
  return reached;
}

// A piece that is shorter than a stretch is one by itself; what a longer one leaves at its end is not seen.
void RoughnessGauge::takeStretches(bool last) {
  while (size_ > 0 && acceleration_.size() >= size_) takeStretch(size_, false);
  const bool seen = taken_ > 0;
  if (last && !seen && acceleration_.size() >= smallest) takeStretch(acceleration_.size(), true);
  if (last) taken_ = 0;
}

void RoughnessGauge::takeStretch(std::size_t size, bool alone) {
  const auto end = static_cast<std::ptrdiff_t>(size);
  const std::vector<double> values(acceleration_.begin(), acceleration_.begin() + end);
  const auto [least, most] = std::minmax_element(speed_.begin(), speed_.begin() + end);
  const double speed = std::accumulate(speed_.begin(), speed_.begin() + end, 0.0) / static_cast<double>(size);
  const std::size_t step = std::max<std::size_t>(1, size / 2);
  const double way = std::abs(speed) * static_cast<double>(step) / rate_;
  const bool usable = std::abs(speed) >= slowest && *most - *least <= steadiness * std::abs(speed) &&
                      std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  heights_[0].resize(size, 0.0);
  for (auto& heights : heights_) heights.resize(size, 0.0);
  const double whole = taken_ == 0 ? 2 * way : way;  // the first one brings its whole length
  if (usable) {
    const auto level = [&] {
      auto copy = values;
      if (!options_.quietEnds) signals::removeTrend(copy.data(), copy.size(), signals::Detrend::linear);
      return copy;
    }();
    addLevels(level, std::abs(speed), whole);
    addHeights(level, std::abs(speed), alone);
    length_ += whole, time_ += whole / std::abs(speed);
  } else {
    left_ += whole;
  }
  ++taken_;
  const PerBand known = usable ? reachedBands(std::abs(speed)) : PerBand{};
  PerBand both{};  // where two windows lie over each other, both stretches must be known
  for (std::size_t b = 0; b < both.size(); ++b) both[b] = known[b] && lastKnown_[b];
  if (alone)
    releaseHeights(size, 2 * way, known);
  else
    releaseHeights(step, way, both);
  lastKnown_ = known;
  acceleration_.erase(acceleration_.begin(), acceleration_.begin() + static_cast<std::ptrdiff_t>(step));
  speed_.erase(speed_.begin(), speed_.begin() + static_cast<std::ptrdiff_t>(step));
}

double RoughnessGauge::transferIndex(double frequency) const {
  const auto& f = transfer_.frequency;
  return (frequency - f.front()) / (f.back() - f.front()) * static_cast<double>(f.size() - 1);
}

void RoughnessGauge::addLevels(const std::vector<double>& acceleration, double speed, double way) {
  const auto spectrum =
      options_.quietEnds ? quietSpectrumOf(acceleration, rate_) : stretchSpectrumOf(acceleration, rate_);
  const double limit = std::min(transfer_.frequency.back(), highestShare * rate_);
  const auto powerAt = [&](const std::vector<double>& power, double f) {
    const double at = transferIndex(f);
    const auto i = std::min(static_cast<std::size_t>(std::max(at, 0.0)), power.size() - 2);
    const double along = std::clamp(at - static_cast<double>(i), 0.0, 1.0);
    return (1 - along) * power[i] + along * power[i + 1];
  };
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const double low = speed / bands_[b].longest, high = speed / bands_[b].shortest;
    if (high > limit || low < transfer_.frequency.front()) continue;
    // Points that divide the band finely against spectrum and transfer function.
    const double fine = std::min(spectrum.step(), transfer_.frequency[1] - transfer_.frequency[0]);
    const auto count = std::max<std::size_t>(16, static_cast<std::size_t>((high - low) / fine));
    const double df = (high - low) / static_cast<double>(count);
    const auto frequencyAt = [&](std::size_t i) { return low + (static_cast<double>(i) + 0.5) * df; };
    const auto filterAt = [&](double f) {
      return squared(contactFilter(options_.filter, speed / f, transfer_.halfPatch));
    };
    const auto heightsWith = [&](const std::vector<double>& response, double* weak) {
      if (response.empty()) return nothing;
      double mean = 0, sum = 0, below = 0;
      for (std::size_t i = 0; i < count; ++i)
        mean += powerAt(response, frequencyAt(i)) * filterAt(frequencyAt(i)) / static_cast<double>(count);
      for (std::size_t i = 0; i < count; ++i) {
        const double f = frequencyAt(i), power = powerAt(response, f) * filterAt(f);
        const double k = f / spectrum.step();
        const auto bin = std::min(static_cast<std::size_t>(k), spectrum.density.size() - 2);
        const double along = k - static_cast<double>(bin);
        const double density = (1 - along) * spectrum.density[bin] + along * spectrum.density[bin + 1];
        sum += density / std::max(power, weakest * mean) * df;
        if (power < weakest * mean) below += 1 / static_cast<double>(count);
      }
      if (weak) *weak = below;
      return sum;
    };
    Sums& sums = sums_[b];
    double weak = 0;
    sums.central += way * heightsWith(transfer_.power, &weak);
    sums.sleeper += way * heightsWith(transfer_.overSleeper.power, nullptr);
    sums.midspan += way * heightsWith(transfer_.midspan.power, nullptr);
    sums.soft += way * heightsWith(transfer_.softPads.power, nullptr);
    sums.stiff += way * heightsWith(transfer_.stiffPads.power, nullptr);
    sums.way += way, sums.weak += way * weak;
  }
}

// Overlapping Hann windows add up to one, so the sum of the filtered stretches is the filtered record. One that stands
// alone is level but for a twentieth at each end.
void RoughnessGauge::addHeights(const std::vector<double>& acceleration, double speed, bool alone) {
  const std::size_t n = acceleration.size();
  const auto window = alone ? levelWindow(n) : signals::windowWeights(signals::Window::hann, n);
  const signals::ComplexTransform forward(n, signals::Direction::forward), backward(n, signals::Direction::backward);
  std::vector<signals::Complex> spectrum(n);
  for (std::size_t i = 0; i < n; ++i) spectrum[i] = acceleration[i] * window[i];
  forward.inPlace(spectrum.data());
  const double limit = std::min(transfer_.frequency.back(), highestShare * rate_);
  for (std::size_t b = 0; b < heights_.size(); ++b) {
    auto passed = spectrum;
    const auto& band = corrugationBands()[b];
    const double least = leastOf(meanPower(transfer_, speed / band.longest, speed / band.shortest));
    for (std::size_t k = 0; k < n; ++k) {
      const double f = static_cast<double>(std::min(k, n - k)) * rate_ / static_cast<double>(n);
      if (f < transfer_.frequency.front() || f > limit) {
        passed[k] = 0;
        continue;
      }
      const double at = transferIndex(f);
      const auto i = std::min(static_cast<std::size_t>(at), transfer_.response.size() - 2);
      const double along = at - static_cast<double>(i);
      auto response = (1 - along) * transfer_.response[i] + along * transfer_.response[i + 1];
      if (2 * k > n) response = std::conj(response);
      // Not divided by less than a third of what the patch lets through where it lets through least, nor by nothing.
      const double filter = std::max(contactFilter(options_.filter, speed / f, transfer_.halfPatch), 0.3);
      passed[k] *= passedByBand(band, speed / f) * std::conj(response) /
                   ((std::norm(response) + least) * filter * static_cast<double>(n));
    }
    backward.inPlace(passed.data());
    for (std::size_t i = 0; i < n; ++i) heights_[b][i] += passed[i].real();
  }
}

void RoughnessGauge::releaseHeights(std::size_t count, double way, const PerBand& known) {
  count = std::min(count, heights_[0].size());
  if (count == 0) return;
  for (std::size_t b = 0; b < heights_.size(); ++b) {
    for (std::size_t i = 0; known[b] && i < count; ++i)
      gauges_[b].add(heights_[b][i], way / static_cast<double>(count));
    if (!known[b]) gauges_[b].skip(way);
    heights_[b].erase(heights_[b].begin(), heights_[b].begin() + static_cast<std::ptrdiff_t>(count));
  }
}

RecordRoughness RoughnessGauge::finish() {
  breakHere();
  RecordRoughness result;
  result.notes = transfer_.notes;
  result.filter = options_.filter;
  result.length = length_, result.left = left_;
  result.speed = time_ > 0 ? length_ / time_ : 0;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const Sums& s = sums_[b];
    RoughnessLevel level;
    level.band = bands_[b];
    level.length = s.way, level.waves = s.way / bands_[b].middle;
    level.level = s.way > 0 ? levelOfSquare(s.central / s.way) : nothing;
    level.weak = s.way > 0 ? s.weak / s.way : 0;
    const auto change = [&](double other) { return std::isfinite(other) ? 10 * std::log10(other / s.central) : 0.0; };
    level.track = 0.5 * std::abs(change(s.sleeper) - change(s.midspan));
    level.pads = std::max(std::abs(change(s.soft)), std::abs(change(s.stiff)));
    const bool once = s.way <= 2.5 * wavesInStretch * options_.longest;
    const auto count = countSpread(degreesOfFreedom(bands_[b], s.way, once));
    level.lowest = level.level - std::hypot(level.track, level.pads, count.below);
    level.highest = level.level + std::hypot(level.track, level.pads, count.above);
    result.levels.push_back(level);
  }
  for (std::size_t b = 0; b < gauges_.size(); ++b)
    if (corrugationBands()[b].longest <= 1.05 * options_.longest &&
        corrugationBands()[b].shortest >= 0.95 * options_.shortest)
      result.corrugation.push_back(gauges_[b].index());
  return result;
}

}  // namespace squat::roughness
