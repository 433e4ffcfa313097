#include "case/Resolve.h"

namespace squat::cases {

scenario::Scenario resolve(const CaseDescription& d) {
  return {d, DefectSurface(d.defect),
          d.defect.moveNodes ? scenario::DefectModel::movedNodes : scenario::DefectModel::gapFunction};
}

scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return resolve(loadCase(nameOrPath, overrides));
}

}  // namespace squat::cases
