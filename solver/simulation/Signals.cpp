#include "simulation/Signals.h"

#include "simulation/TracksideSensors.h"

namespace squat::simulation {

std::vector<Signal> outputSignals(const dynamics::Rolling& rolling) {
  using dynamics::Rolling;
  const auto& model = rolling.model();
  const double sensor = model.scenario.output.railAccelerometer;
  std::vector<Signal> signals{
      {"aba", "m/s2", "vertical acceleration of the axle box, up positive, anti-aliased",
       [](const Rolling& r) { return r.view().boxAcceleration.z; }, "aba_filtered"},
      {"aba_longitudinal", "m/s2", "longitudinal acceleration of the axle box, rolling direction positive",
       [](const Rolling& r) { return r.view().boxAcceleration.x; }},
      {"wheel_acceleration", "m/s2", "vertical acceleration of the wheel centre, up positive",
       [](const Rolling& r) { return r.view().wheelAcceleration.z; }, "wheel_acceleration_filtered"},
      {"contact_force", "N", "vertical force of the wheel on the rail, down positive",
       [](const Rolling& r) { return r.view().patch.vertical; }},
      {"creep_force", "N", "longitudinal force of the wheel on the rail, rolling direction positive",
       [](const Rolling& r) { return r.view().patch.longitudinal; }},
      {"wheel_speed", "rad/s", "angular velocity of the wheelset",
       [](const Rolling& r) { return r.view().angularVelocity; }},
      {"patch_length", "m", "2 sqrt(5 <x2>) of the pressure", [](const Rolling& r) { return r.view().patch.length; }},
      {"patch_width", "m", "2 sqrt(5 <y2>) of the pressure", [](const Rolling& r) { return r.view().patch.width; }},
      {"rail_acceleration", "m/s2", "vertical acceleration of the rail foot at output.rail_accelerometer, up positive",
       Accelerometer(railFootAt(model, sensor), rolling)},
      {"sleeper_acceleration", "m/s2",
       "vertical acceleration of the sleeper nearest to output.rail_accelerometer, below the rail, up positive",
       Accelerometer(sleeperTopNear(model, sensor), rolling)},
      {"position", "m", "wheel centre relative to the deepest point of the defect",
       [](const Rolling& r) { return r.view().position; }},
  };
  if (!model.scenario.irregularity.isSmooth())
    signals.insert(signals.end() - 1,
                   {"irregularity", "m", "height of the rail's irregularity below the wheel centre, up positive",
                    [](const Rolling& r) { return r.model().scenario.irregularity.height(r.view().position); }});
  return signals;
}

}  // namespace squat::simulation
