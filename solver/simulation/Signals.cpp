#include "simulation/Signals.h"

#include <map>
#include <string_view>

#include "simulation/TracksideSensors.h"

namespace squat::simulation {
namespace {

std::map<std::string_view, Probe> probes(const dynamics::Rolling& rolling) {
  namespace names = signals::names;
  using dynamics::Rolling;
  const auto& model = rolling.model();
  const double sensor = model.scenario.output.railAccelerometer;
  std::map<std::string_view, Probe> probes{
      {names::axleBox, [](const Rolling& r) { return r.view().boxAcceleration.z; }},
      {names::axleBoxLongitudinal, [](const Rolling& r) { return r.view().boxAcceleration.x; }},
      {names::wheel, [](const Rolling& r) { return r.view().wheelAcceleration.z; }},
      {names::contactForce, [](const Rolling& r) { return r.view().patch.vertical; }},
      {names::creepForce, [](const Rolling& r) { return r.view().patch.longitudinal; }},
      {names::wheelSpeed, [](const Rolling& r) { return r.view().angularVelocity; }},
      {names::patchLength, [](const Rolling& r) { return r.view().patch.length; }},
      {names::patchWidth, [](const Rolling& r) { return r.view().patch.width; }},
      {names::rail, Accelerometer(railFootAt(model, sensor), rolling)},
      {names::sleeper, Accelerometer(sleeperTopNear(model, sensor), rolling)},
      {names::position, [](const Rolling& r) { return r.view().position; }}};
  if (model.scenario.extent == scenario::ModelExtent::whole)
    probes[names::axleBoxLateral] = [](const Rolling& r) { return r.view().boxLateralAcceleration; };
  if (rolling.sides().size() > 1)
    probes[names::wheelsetRoll] = [](const Rolling& r) {
      const double rises = r.view().wheelAcceleration.z, other = r.sides()[1]->view().wheelAcceleration.z;
      return (rises - other) / (2 * r.model().scenario.wheelset.trackCentre);
    };
  if (model.second) {
    probes[names::secondAxleBox] = [](const Rolling& r) { return r.view().second.boxAcceleration; };
    probes[names::secondContactForce] = [](const Rolling& r) { return r.view().second.force; };
  }
  if (!model.scenario.irregularity.isSmooth())
    probes[names::irregularity] = [](const Rolling& r) {
      return r.model().scenario.irregularity.height(r.view().position);
    };
  return probes;
}

}  // namespace

std::vector<Signal> outputSignals(const dynamics::Rolling& rolling) {
  auto left = probes(rolling);
  std::map<std::string_view, Probe> right;
  if (rolling.sides().size() > 1) right = probes(*rolling.sides()[1]);
  std::vector<Signal> output;
  for (const auto& row : signals::signalCatalogue())
    if (row.left) {
      if (const auto probe = right.find(row.left); probe != right.end())
        output.push_back(
            {row, [own = std::move(probe->second)](const dynamics::Rolling& r) { return own(*r.sides()[1]); }});
    } else if (const auto probe = left.find(row.name); probe != left.end()) {
      output.push_back({row, std::move(probe->second)});
    }
  return output;
}

}  // namespace squat::simulation
