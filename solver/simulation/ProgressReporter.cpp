#include "simulation/ProgressReporter.h"

#include <algorithm>

#include "signals/SignalCatalogue.h"

namespace squat::simulation {

ProgressReporter::ProgressReporter(const dynamics::Rolling& rolling, long lastStep, const SignalRecorder& signals,
                                   const EnergyBalance& balance, const RunClock& clock, Monitor& monitor)
    : firstStep_(rolling.state().step),
      lastStep_(lastStep),
      signals_(signals),
      balance_(balance),
      clock_(clock),
      monitor_(monitor) {}

void ProgressReporter::onStep(const dynamics::Rolling& rolling) {
  const long done = rolling.state().step;
  const double seconds = clock_.seconds();
  if (seconds - lastReport_ < 0.1 && done < lastStep_) return;
  lastReport_ = seconds;
  Progress p;
  p.phase = "rolling";
  // The way to a warm state ends where the wheel comes near the defect, at a step that is known only approximately.
  p.fraction = std::min(1.0, static_cast<double>(done) / static_cast<double>(lastStep_));
  p.simulatedTime = rolling.state().time;
  const double rate = static_cast<double>(done - firstStep_) / std::max(seconds, 1e-3);
  if (seconds > 0.5) p.remainingSeconds = static_cast<double>(std::max(0L, lastStep_ - done)) / std::max(rate, 1e-3);
  for (const auto* side : rolling.sides())
    p.elementUpdatesPerSecond += rate * static_cast<double>(side->model().elements());
  p.position = rolling.view().position;
  p.contactForce = rolling.view().patch.vertical;
  p.axleBoxAcceleration = signals_.latest(signals::names::axleBox);
  p.accelerationPosition = p.simulatedTime > signals_.wait() ? signals_.latest(signals::names::position) : p.position;
  p.energyResidual = balance_.relativeResidual();
  monitor_.report(p);
}

}  // namespace squat::simulation
