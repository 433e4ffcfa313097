// solver/signals/SignalError.h - what is wrong with a signal or with what was asked of it.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

// The signal or the request is wrong: one sentence with the number found and the number allowed. Programs turn it into
// the error of their layer (a wrong case or a wrong file).
class SignalError : public std::invalid_argument {
 public:
  explicit SignalError(const std::string& what) : std::invalid_argument(what) {}
  SignalError(const std::string& what, std::size_t sample) : std::invalid_argument(what), sample_(sample) {}
  // Index of the offending sample, where there is one.
  std::optional<std::size_t> sample() const { return sample_; }

 private:
  std::optional<std::size_t> sample_;
};

// Refuses a signal with fewer than `minimum` samples, with a step that is not a positive finite number, or with values
// that are not finite; the message names the first such sample. `use` completes the sentence, e.g. "a power spectrum".
void requireUsable(const TimeSeries& series, std::size_t minimum, const std::string& use);
void requireFinite(const std::vector<double>& values, const std::string& name);

// Refuses a signal whose values are all the same: it has no spectrum, peak or wavelength.
void requireVarying(const TimeSeries& series, const std::string& use);

}  // namespace squat::signals
