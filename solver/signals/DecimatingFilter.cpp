#include "signals/DecimatingFilter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "signals/BesselI0.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

// Kaiser, Nonrecursive digital filter design, 1974: shape and length from the attenuation A [dB] and the width of the
// transition [rad/sample]: beta = 0.1102 (A - 8.7) for A > 50, length - 1 = (A - 7.95)/(2.285 width).
double kaiserBeta(double attenuation) { return 0.1102 * (attenuation - 8.7); }

}  // namespace

DecimatingFilter::DecimatingFilter(double inputStep, std::size_t factor, std::size_t channels,
                                   DecimatingFilterOptions options)
    : inputStep_(inputStep), factor_(factor), channels_(channels), half_(0) {
  if (!(std::isfinite(inputStep) && inputStep > 0)) throw SignalError("the input step must be a positive time");
  if (factor < 2 || channels == 0)
    throw SignalError("decimation needs a factor of at least 2 and at least one channel");
  const double outputRate = 1 / outputStep();
  if (options.stopEdge == 0) options.stopEdge = outputRate / 2;
  if (!(options.passEdge > 0 && options.passEdge < options.stopEdge && options.stopAttenuation >= 60)) {
    std::ostringstream text;
    text << "the output rate of " << outputRate << " Hz is too low for signals up to " << options.passEdge
         << " Hz: the pass edge must be below the stop edge of " << options.stopEdge << " Hz";
    throw SignalError(text.str());
  }
  const double width = 2 * std::numbers::pi * (options.stopEdge - options.passEdge) * inputStep;
  const double cut = std::numbers::pi * (options.stopEdge + options.passEdge) * inputStep;
  half_ = static_cast<std::size_t>(std::ceil((options.stopAttenuation - 7.95) / (2.285 * width) / 2));
  const double beta = kaiserBeta(options.stopAttenuation);
  weights_.resize(2 * half_ + 1);
  double sum = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double t = static_cast<double>(i) - static_cast<double>(half_);
    const double r = t / (static_cast<double>(half_) + 1);
    const double sinc = t == 0 ? cut : std::sin(cut * t) / t;
    weights_[i] = sinc * besselI0(beta * std::sqrt(1 - r * r));
    sum += weights_[i];
  }
  cumulative_.assign(weights_.size() + 1, 0.0);
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    weights_[i] /= sum;
    cumulative_[i + 1] = cumulative_[i] + weights_[i];
  }
  state_.complete.resize(channels_);
}

std::uint64_t DecimatingFilter::firstPending() const { return state_.complete.front().size(); }

// Adds input sample `index` into all outputs k with |index - k factor| <= half, making room for new ones.
void DecimatingFilter::add(std::vector<double>& pending, std::uint64_t first, const double* sample,
                           std::uint64_t index) const {
  const std::uint64_t from = index > half_ ? (index - half_ + factor_ - 1) / factor_ : 0;
  const std::uint64_t to = (index + half_) / factor_;
  const std::size_t room = static_cast<std::size_t>(to + 1 - first) * channels_;
  if (pending.size() < room) pending.resize(room, 0.0);
  for (std::uint64_t k = std::max(from, first); k <= to; ++k) {
    const double weight = weights_[static_cast<std::size_t>(index + half_ - k * factor_)];
    double* sums = pending.data() + static_cast<std::size_t>(k - first) * channels_;
    for (std::size_t c = 0; c < channels_; ++c) sums[c] += weight * sample[c];
  }
}

void DecimatingFilter::push(const double* sample) {
  if (state_.pushed == 0) {
    // The samples before the first one, all equal to it: output k takes the weights that reach below index 0.
    for (std::uint64_t k = 0; k * factor_ < half_; ++k)
      for (std::size_t c = 0; c < channels_; ++c)
        state_.pending.push_back(cumulative_[half_ - static_cast<std::size_t>(k) * factor_] * sample[c]);
  }
  add(state_.pending, firstPending(), sample, state_.pushed);
  state_.last.assign(sample, sample + channels_);
  const std::uint64_t index = state_.pushed++;
  // Output k is complete with input k factor + half.
  if (index >= half_ && (index - half_) % factor_ == 0) {
    for (std::size_t c = 0; c < channels_; ++c) state_.complete[c].push_back(state_.pending[c]);
    state_.pending.erase(state_.pending.begin(), state_.pending.begin() + static_cast<std::ptrdiff_t>(channels_));
  }
}

std::vector<TimeSeries> DecimatingFilter::finish(double start) const {
  std::vector<TimeSeries> result(channels_);
  const std::uint64_t outputs = state_.pushed ? (state_.pushed - 1) / factor_ + 1 : 0;
  const std::uint64_t first = firstPending();
  for (std::size_t c = 0; c < channels_; ++c) {
    auto& values = result[c].values;
    result[c].start = start;
    result[c].step = outputStep();
    values = state_.complete[c];
    for (std::uint64_t k = first; k < outputs; ++k) {
      // Weights from position `pushed` on have not been used: they all get the last sample.
      const auto used = static_cast<std::size_t>(state_.pushed + half_ - k * factor_);
      values.push_back(state_.pending[static_cast<std::size_t>(k - first) * channels_ + c] +
                       (cumulative_.back() - cumulative_[used]) * state_.last[c]);
    }
  }
  return result;
}

double DecimatingFilter::latest(std::size_t channel) const {
  const auto& values = state_.complete.at(channel);
  return values.empty() ? 0.0 : values.back();
}

double DecimatingFilter::gainAt(double frequency) const {
  double gain = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i)
    gain += weights_[i] * std::cos(2 * std::numbers::pi * frequency * inputStep_ *
                                   (static_cast<double>(i) - static_cast<double>(half_)));
  return std::abs(gain);
}

void DecimatingFilter::restore(DecimatingFilterState state) {
  if (state.complete.size() != channels_ || (state.pushed > 0 && state.last.size() != channels_))
    throw SignalError("the stored filter state belongs to another number of channels");
  // What must stand after so many inputs: outputs up to the last whole one, sums for those that the last input reaches.
  const std::uint64_t whole = state.pushed > half_ ? (state.pushed - 1 - half_) / factor_ + 1 : 0;
  const std::uint64_t reached = state.pushed > 0 ? (state.pushed - 1 + half_) / factor_ + 1 : whole;
  bool fits = state.pending.size() == (reached - whole) * channels_;
  for (const auto& values : state.complete) fits = fits && values.size() == whole;
  if (!fits) throw SignalError("the stored filter state does not belong to its number of samples");
  state_ = std::move(state);
}

}  // namespace squat::signals
