// solver/signals/DecimatingFilter.h - from the solver's steps to the output rate without aliasing and without delay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

struct DecimatingFilterOptions {
  double passEdge = 6000;       // [Hz] flat within 0.01 dB below
  double stopEdge = 0;          // [Hz] suppressed above; 0: half the output rate
  double stopAttenuation = 90;  // [dB] design value of the Kaiser window; 80 dB are kept with room
};

// Everything that changes while samples arrive, in plain vectors: what a checkpoint has to hold.
struct DecimatingFilterState {
  std::uint64_t pushed = 0;                   // input samples so far
  std::vector<double> last;                   // last input sample, one value per channel
  std::vector<double> pending;                // sums of outputs not yet complete, output by output, channels inside
  std::vector<std::vector<double>> complete;  // complete outputs, per channel
};

// Linear-phase low-pass (windowed sinc, Kaiser) that keeps every factor-th sample. Output k is centred on input sample
// k * factor, so it belongs exactly to that time. Before the first and after the last sample the record is continued by
// repeating that sample. Each sample is added into the few outputs that reach it (about 25 at the default edges,
// whatever the factor), so a push costs 25 multiply-adds a channel.
class DecimatingFilter {
 public:
  // factor: input samples per output sample, at least 2; inputStep [s]. Throws SignalError where the edges do not fit.
  DecimatingFilter(double inputStep, std::size_t factor, std::size_t channels, DecimatingFilterOptions options = {});

  // One value per channel. The first pushed sample is output 0's centre.
  void push(const double* sample);

  // The outputs so far, and those that still wait completed by repeating the last sample. `start` is the time of the
  // first pushed sample. The filter itself is not changed: it can go on.
  std::vector<TimeSeries> finish(double start = 0.0) const;

  // Newest complete output of a channel; 0 while there is none.
  double latest(std::size_t channel) const;

  std::size_t channels() const { return channels_; }
  std::size_t factor() const { return factor_; }
  double outputStep() const { return inputStep_ * static_cast<double>(factor_); }
  // [s] by which an output waits for the samples behind its centre.
  double wait() const { return inputStep_ * static_cast<double>(half_); }
  // Amplitude gain at a frequency [Hz] up to half the input rate.
  double gainAt(double frequency) const;

  const DecimatingFilterState& state() const { return state_; }
  // Throws SignalError where the state belongs to another number of channels.
  void restore(DecimatingFilterState state);

 private:
  void add(std::vector<double>& pending, std::uint64_t firstPending, const double* sample, std::uint64_t index) const;
  std::uint64_t firstPending() const;

  double inputStep_;
  std::size_t factor_, channels_, half_;
  std::vector<double> weights_;     // 2 half + 1, sum 1
  std::vector<double> cumulative_;  // cumulative_[i] = weights_[0] + .. + weights_[i-1]
  DecimatingFilterState state_;
};

}  // namespace squat::signals
