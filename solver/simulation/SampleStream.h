// solver/simulation/SampleStream.h - hands the samples of the axle box acceleration on while a run rolls.
#pragma once

#include <functional>
#include <utility>

#include "signals/SignalCatalogue.h"
#include "simulation/SignalRecorder.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

// Every sample once, in order, as soon as its filter is complete. Those that a stored state holds are not repeated.
class SampleStream : public StepObserver {
 public:
  using Take = std::function<void(double position, double acceleration)>;  // [m], [m/s2]

  // Behind the recorder in the list of observers, so that it sees what the recorder has loaded.
  SampleStream(const SignalRecorder& recorder, Take take) : recorder_(recorder), take_(std::move(take)) {}

  void onStep(const dynamics::Rolling&) override {
    const auto count = recorder_.samples();
    if (passed_ == count) return;
    const auto &position = recorder_.recorded(signals::names::position),
               &acceleration = recorder_.recorded(signals::names::axleBox);
    for (; passed_ < count; ++passed_) take_(position[passed_], acceleration[passed_]);
  }
  void load(const results::ArrayTree&, const std::string& /*file*/) override { passed_ = recorder_.samples(); }

 private:
  const SignalRecorder& recorder_;
  Take take_;
  std::size_t passed_ = 0;
};

}  // namespace squat::simulation
