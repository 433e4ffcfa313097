#include <algorithm>
#include <cmath>

#include "case/RightSide.h"
#include "core/Errors.h"
#include "growth/Grow.h"
#include "growth/RollingTraffic.h"
#include "growth/StageFigures.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

void requireRoom(const cases::CaseDescription& c, const DefectExtent& extent) {
  const double before = endEffect + fadingLength - extent.first, behind = extent.last + fadingLength;
  std::vector<CaseProblem> problems;
  const auto require = [&](const char* key, double stated, double least) {
    constexpr double roundOff = 1e-9;
    if (stated >= least - roundOff) return;
    problems.push_back(
        {key, text::fixedText(1e3 * stated, 2) + " mm",
         "at least " + text::fixedText(std::ceil(1e4 * least) / 10, 1) + " mm",
         "The stretch that grows has to hold the defect and undisturbed rail on both sides: raise it, or "
         "leave it out"});
  };
  require("mesh.zone_before", c.mesh.zoneBefore, before);
  require("mesh.zone_behind", c.mesh.zoneBehind, behind);
  if (!problems.empty()) throw CaseError(problems);
}

}  // namespace

cases::CaseDescription growingCase(cases::CaseDescription c) {
  constexpr double before = 0.050, behind = 0.120, runUp = 0.40, beyond = 0.05;  // [m]
  cases::requireHalf(c, "growth");
  cases::requireSingleWheelset(c, "growth");
  constexpr double ramp = 0.008;  // [s] so slow that the wheelset's torsion, some 500 Hz, is hardly excited
  const DefectExtent extent = extentOf(c);
  auto& mesh = c.mesh;
  if (mesh.zoneBefore <= 0) mesh.zoneBefore = before - extent.first;
  if (mesh.zoneBehind <= 0) mesh.zoneBehind = extent.last + behind;
  requireRoom(c, extent);
  c.motion.runUp = std::max(c.motion.runUp, mesh.zoneBefore + mesh.fineBefore + runUp);
  c.motion.beyond = std::max(c.motion.beyond, mesh.zoneBehind + beyond);
  c.motion.torqueRamp = std::max(c.motion.torqueRamp, ramp);
  c.rail.plasticFrom = -mesh.zoneBefore, c.rail.plasticTo = mesh.zoneBehind;
  c.rail.plasticMiddle = extent.touch;
  double aside = 0;
  for (const auto& draw : drawTraffic(c.growth)) aside = std::max(aside, std::abs(draw.lateral));
  mesh.bandHalfWidth += aside;
  return c;
}

}  // namespace squat::growth
