#include "case/ForceCurveText.h"

#include <cmath>

#include "case/DecimalNumber.h"
#include "case/PointsText.h"

namespace squat::cases {

namespace {

constexpr int millimetres = -3, kilonewtons = 3;

}  // namespace

std::optional<std::vector<ForcePoint>> parseForceCurve(std::string_view text) {
  const auto pairs = parsePoints(text, millimetres, kilonewtons);
  if (!pairs) return std::nullopt;
  std::vector<ForcePoint> curve;
  for (const auto& pair : *pairs) curve.push_back({pair.position, pair.height});
  return curve;
}

std::string formatForceCurve(const std::vector<ForcePoint>& curve) {
  std::string text = "[";
  for (const auto& point : curve)
    text += (text.size() > 1 ? ", [" : "[") + formatDecimal(point.compression, millimetres) + ", " +
            formatDecimal(point.force, kilonewtons) + "]";
  return text + "]";
}

std::string forceCurveMistake(const std::vector<ForcePoint>& curve) {
  constexpr std::size_t maximumCurvePoints = 100;
  constexpr double farthest = 0.05, strongest = 1e7, softest = 1e4, stiffest = 2e10;  // [m], [N], [N/m]
  if (curve.size() == 1) return "Give at least two points";
  if (curve.size() > maximumCurvePoints) return "Give at most " + std::to_string(maximumCurvePoints) + " points";
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const std::string which = "Point " + std::to_string(i + 1) + ": ";
    if (!(std::abs(curve[i].compression) <= farthest)) return which + "compressions go from -50 to 50 mm";
    if (!(std::abs(curve[i].force) <= strongest)) return which + "forces go from -10000 to 10000 kN";
    if (i == 0) continue;
    const double further = curve[i].compression - curve[i - 1].compression, more = curve[i].force - curve[i - 1].force;
    if (!(further > 0)) return which + "compressions must ascend";
    if (!(more > 0)) return which + "the force must rise with the compression";
    if (more < softest * further || more > stiffest * further)
      return which + "from one point to the next the stiffness must lie between 0.01 and 20000 MN/m (kN/mm)";
  }
  return {};
}

}  // namespace squat::cases
