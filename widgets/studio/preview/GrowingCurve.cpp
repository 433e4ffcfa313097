#include "studio/preview/GrowingCurve.h"

#include "signals/Butterworth.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "simulation/SignalRecorder.h"

namespace squat::studio {

GrowingCurve::GrowingCurve(const simulation::WarmState& state, double rate, double cutoff)
    : rate_(rate),
      cutoff_(cutoff),
      position_(simulation::recordedIn(state.state, "position")),
      acceleration_(simulation::recordedIn(state.state, signals::names::axleBox)) {}

void GrowingCurve::add(double position, double acceleration) {
  position_.push_back(position);
  acceleration_.push_back(acceleration);
}

std::vector<double> GrowingCurve::filtered() const {
  signals::TimeSeries series;
  series.step = 1 / rate_;
  series.values = acceleration_;
  try {
    return signals::lowPass(series, cutoff_).values;
  } catch (const signals::SignalError&) {
    return acceleration_;
  }
}

}  // namespace squat::studio
