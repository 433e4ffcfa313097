// solver/simulation/SignalRecorder.h - every output signal on the solver's own steps, low-passed and thinned out to the
// output rate.
#pragma once

#include <cstddef>

#include "results/RunResult.h"
#include "signals/DecimatingFilter.h"
#include "simulation/Signals.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

class SignalRecorder : public StepObserver {
 public:
  SignalRecorder(const dynamics::Rolling& rolling, std::size_t stepsPerSample);

  void onEveryStep(const dynamics::Rolling& rolling) override;
  void save(results::ArrayTree& tree) const override;
  void load(const results::ArrayTree& tree, const std::string& file) override;

  // The newest value of a signal whose filter is complete, 0 where there is none; `wait` [s] behind the last step.
  double latest(const std::string& name) const;
  double wait() const { return filter_.wait(); }
  // Number of samples whose filter is complete, and those of a signal. Throws std::out_of_range for an unknown name.
  std::size_t samples() const { return filter_.state().complete.front().size(); }
  const std::vector<double>& recorded(const std::string& name) const;

  // Writes time, position and signals, at most `samples` of each; low-passed ones at `cutoff` [Hz] as well.
  void store(results::RunResult& result, std::size_t samples, double cutoff) const;

 private:
  std::vector<Signal> signals_;
  std::vector<double> sample_;  // of the step just made
  signals::DecimatingFilter filter_;
};

// The values of a signal that a stored state holds: those whose filter is complete, from the start of rolling at the
// output rate. Empty where there is none of that name ("position" is among them).
std::vector<double> recordedIn(const results::ArrayTree& tree, const std::string& name);

}  // namespace squat::simulation
