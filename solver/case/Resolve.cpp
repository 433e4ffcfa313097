#include "case/Resolve.h"

#include <algorithm>

#include "case/DynamicPads.h"
#include "case/LevelsText.h"
#include "case/RightSide.h"
#include "scenario/WheelsetMass.h"

namespace squat::cases {

scenario::DefectSurface surfaceOf(const CaseDescription& description) { return DefectSurface(description.defect); }

scenario::TreadDeviation treadOf(const CaseDescription& description) {
  return scenario::TreadDeviation(description.tread, description.wheelset.radius);
}

namespace {

// [m] `start`: where the wheel stands at first.
IrregularSurface irregularityFrom(const CaseDescription& description, double start) {
  const auto& rail = description.rail.irregularity;
  if (rail.kind == IrregularityKind::none) return {};
  if (rail.kind == IrregularityKind::heights) return IrregularSurface::ofHeights(rail, start);
  return IrregularSurface::ofSpectrum(levelsOf(rail), rail, start);
}

}  // namespace

IrregularSurface irregularityOf(const CaseDescription& description) {
  return irregularityFrom(description, -description.motion.runUp);
}

std::vector<WavelengthLevel> levelsOf(const Irregularity& rail) {
  if (rail.kind == IrregularityKind::iso3095) return scenario::iso3095Limit();
  return parseLevels(rail.levels).value_or(std::vector<WavelengthLevel>());
}

DefectZone defectZone(const CaseDescription& description) {
  const auto zoneOf = [](const CaseDescription& side) {
    return scenario::defectZone(surfaceOf(side), treadOf(side), side.mesh);
  };
  const auto left = zoneOf(description);
  if (description.extent == ModelExtent::half) return left;
  const auto right = zoneOf(rightOf(description));
  return {std::max(left.before, right.before), std::max(left.behind, right.behind)};
}

scenario::Scenario resolve(const CaseDescription& d) {
  scenario::Scenario resolved{
      static_cast<const scenario::Inputs&>(d),
      surfaceOf(d),
      d.defect.moveNodes ? scenario::DefectModel::movedNodes : scenario::DefectModel::gapFunction,
      treadOf(d),
      irregularityOf(d),
      {}};
  if (d.bogie.hasSecond()) resolved.irregularityUnderSecond = irregularityFrom(d, d.bogie.offset() - d.motion.runUp);
  resolved.pad.dynamic = parseDynamicStiffness(d.pad.dynamicValues).value_or(std::vector<scenario::DynamicStiffness>());
  resolved.wheelset.totalMass = scenario::wheelsetMass(d.wheelset);
  return resolved;
}

Sides resolveSides(const CaseDescription& description) {
  Sides sides{resolve(description), {}};
  if (description.extent == ModelExtent::half) return sides;
  sides.right = resolve(rightOf(description));
  sides.right->extent = ModelExtent::whole;
  const auto zoneOf = [](const scenario::Scenario& d) {
    return scenario::defectZone(d.defectSurface, d.tread, d.mesh);
  };
  const auto left = zoneOf(sides.left), right = zoneOf(*sides.right);
  for (auto* side : {&sides.left, &*sides.right}) {
    side->mesh.zoneBefore = std::max(left.before, right.before);
    side->mesh.zoneBehind = std::max(left.behind, right.behind);
  }
  return sides;
}

scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return resolve(loadCase(nameOrPath, overrides));
}

}  // namespace squat::cases
