#include "case/Resolve.h"

namespace squat::cases {

scenario::Scenario resolve(const CaseDescription& d) {
  return {d.track,
          d.rail,
          d.pad,
          d.sleeper,
          d.ballast,
          d.wheelset,
          d.suspension,
          d.motion,
          d.contact,
          d.damping,
          d.mesh,
          DefectSurface(d.defect),
          d.defect.moveNodes ? scenario::DefectModel::movedNodes : scenario::DefectModel::gapFunction,
          d.output};
}

scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return resolve(loadCase(nameOrPath, overrides));
}

}  // namespace squat::cases
