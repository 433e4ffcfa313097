#include "case/Resolve.h"

#include "scenario/WheelsetMass.h"

namespace squat::cases {

scenario::DefectSurface surfaceOf(const CaseDescription& description) { return DefectSurface(description.defect); }

DefectZone defectZone(const CaseDescription& description) {
  return scenario::defectZone(surfaceOf(description), description.mesh);
}

scenario::Scenario resolve(const CaseDescription& d) {
  scenario::Scenario resolved{
      static_cast<const scenario::Inputs&>(d), surfaceOf(d),
      d.defect.moveNodes ? scenario::DefectModel::movedNodes : scenario::DefectModel::gapFunction};
  resolved.wheelset.totalMass = scenario::wheelsetMass(d.wheelset);
  return resolved;
}

scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return resolve(loadCase(nameOrPath, overrides));
}

}  // namespace squat::cases
