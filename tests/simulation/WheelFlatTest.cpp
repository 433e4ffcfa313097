// A wheel flat rolls over smooth rail, on the tiny mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "scenario/TreadDeviation.h"
#include "simulation/RunCase.h"

namespace squat {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

results::RunResult runOf(const std::string& name, const Settings& values) {
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = false, options.snapshots = false;
  Monitor silent;
  return simulation::runCase(cases::loadCase(name, {"tiny", values}), options, silent);
}

double energyResidual(const results::RunResult& result) {
  for (const auto& item : result.performance)
    if (item.name == "energy_residual") return item.value;
  ADD_FAILURE();
  return 1;
}

std::string cosineDip(double length, double depth) {  // [mm]
  std::string points;
  const int count = static_cast<int>(length);
  for (int i = 0; i <= count; ++i)
    points += (points.empty() ? "[[" : ", [") + std::to_string(i) + ", " +
              std::to_string(-0.5 * depth * (1 - std::cos(2 * std::acos(-1.0) * i / count))) + "]";
  return points + "]";
}

// The relative motion of wheel and rail is that of their deviations together, whichever of them has it: the moving
// irregularity of theory. A dip in the tread shakes the wheel as the same dip in the rail. Not to the bit: the wheel
// with the dip rolls on its lower side, by 0.15 mm of 460, and friction has another lever. Tolerance 1 % of the peak:
// of the slopes 0.01 that tilt the normal here and not there (force), and of the mesh, 5 mm under a dip of 50.
TEST(WheelFlat, ADipInTheTreadShakesTheWheelAsTheSameDipInTheRail) {
  const Settings common{{"motion.torque", "0"}, {"mesh.zone_before", "30"}, {"mesh.zone_behind", "30"}};
  auto onRail = common, onWheel = common;
  onRail.insert(onRail.end(), {{"defect.shape", "profile"}, {"defect.points", cosineDip(50, 0.15)}});
  onWheel.push_back({"wheelset.tread_points", cosineDip(50, 0.15)});
  const auto rail = runOf(tests::fixtureCase("smooth-rail"), onRail);
  const auto wheel = runOf(tests::fixtureCase("smooth-rail"), onWheel);
  const auto &a = *rail.signal("aba_filtered"), &b = *wheel.signal("aba_filtered");
  ASSERT_EQ(a.size(), b.size());
  double peak = 0, difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    peak = std::max(peak, std::abs(a[i]));
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  EXPECT_GT(peak, 20);
  EXPECT_LT(difference, 0.01 * peak);
  std::printf("  peak %.1f m/s2, largest difference %.2f %% of it\n", peak, 100 * difference / peak);
  EXPECT_LT(energyResidual(wheel), 1e-3);
}

// The wheel falls into its flat with all of its load behind it, at most with weight over unsprung mass, and strikes
// where that parabola meets the path of a rigid wheel: behind the flat's middle, the farther the faster it rolls. The
// rail, freed of the load, rises towards it, and the wheel strikes earlier.
TEST(WheelFlat, StrikesBehindTheMiddleOfTheFlat) {
  const auto scenario = cases::loadScenario("wheel-flat", {"tiny", {}});
  for (const double speed : {10.0, 20.0}) {
    const auto result = runOf("wheel-flat", {{"motion.speed", std::to_string(speed)}});
    ASSERT_TRUE(result.complete);
    const auto& force = *result.signal("contact_force");
    const auto at = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
    const double found = result.position[at];
    std::printf("  %.0f m/s: %.0f kN at %.1f mm, energy %.2g\n", speed, 1e-3 * force[at], 1e3 * found,
                energyResidual(result));
    EXPECT_GT(found, 0) << speed;
    EXPECT_LT(found, scenario.tread.dipBehind()) << speed;
    EXPECT_LT(energyResidual(result), 2e-3) << speed;
  }
}

}  // namespace
}  // namespace squat
