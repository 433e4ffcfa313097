#include "case/Resolve.h"

#include "scenario/WheelsetMass.h"

namespace squat::cases {

scenario::DefectSurface surfaceOf(const CaseDescription& description) { return DefectSurface(description.defect); }

scenario::TreadDeviation treadOf(const CaseDescription& description) {
  return scenario::TreadDeviation(description.tread, description.wheelset.radius);
}

DefectZone defectZone(const CaseDescription& description) {
  return scenario::defectZone(surfaceOf(description), treadOf(description), description.mesh);
}

scenario::Scenario resolve(const CaseDescription& d) {
  scenario::Scenario resolved{
      static_cast<const scenario::Inputs&>(d), surfaceOf(d),
      d.defect.moveNodes ? scenario::DefectModel::movedNodes : scenario::DefectModel::gapFunction, treadOf(d)};
  resolved.wheelset.totalMass = scenario::wheelsetMass(d.wheelset);
  return resolved;
}

scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return resolve(loadCase(nameOrPath, overrides));
}

}  // namespace squat::cases
