// solver/simulation/EnergyObserver.h - makes the entries of the energy balance while the wheel rolls.
#pragma once

#include "simulation/EnergyBalance.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

// An entry needs the state before a step and right after it: every `interval` steps it looks twice in a row.
class EnergyObserver : public StepObserver {
 public:
  EnergyObserver(EnergyBalance& balance, long interval) : balance_(balance), interval_(interval) {}

  long nextStep(long done) const override;
  void onStart(const dynamics::Rolling& rolling) override { balance_.before(rolling); }
  void onStep(const dynamics::Rolling& rolling) override;
  void save(results::ArrayTree& tree) const override;
  void load(const results::ArrayTree& tree, const std::string& file) override;

 private:
  EnergyBalance& balance_;
  long interval_;
};

}  // namespace squat::simulation
