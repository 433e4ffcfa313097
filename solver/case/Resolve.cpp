#include "case/Resolve.h"

#include "scenario/WheelsetMass.h"

namespace squat::cases {

scenario::Scenario resolve(const CaseDescription& d) {
  scenario::Scenario resolved{
      d, DefectSurface(d.defect),
      d.defect.moveNodes ? scenario::DefectModel::movedNodes : scenario::DefectModel::gapFunction};
  resolved.wheelset.totalMass = scenario::wheelsetMass(d.wheelset);
  return resolved;
}

scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return resolve(loadCase(nameOrPath, overrides));
}

}  // namespace squat::cases
