// A run whose rail yields: what it promises, seen from outside.
#include "simulation/PlasticRun.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "simulation/StoppedRuns.h"

namespace squat {
namespace {

using tests::CancelAt;
using tests::comparable;
using tests::plain;
using tests::run;
using tests::scalar;
using tests::softRail;
using tests::yielded;

// The wheel presses a groove: vertical shortening, which is all there is on the axis of a contact without sliding,
// summed over depth. Shortening by e alone is an equivalent strain e, and elastic stresses that stay add little: within
// a tenth where the groove is deepest, and a fifth along the smooth rail before the dip, where it is half as deep.
TEST(PlasticRun, TheGrooveIsTheShorteningUnderIt) {
  const auto& change = yielded().permanent;
  const std::size_t across = change.lateral.size(), down = change.depth.size();
  ASSERT_EQ(change.height.size(), change.position.size() * across);
  const auto shortening = [&](std::size_t i) {
    double sum = 0;
    for (std::size_t k = 1; k < down; ++k)
      sum += 0.5 * (change.equivalentStrain[i * down + k] + change.equivalentStrain[i * down + k - 1]) *
             (change.depth[k] - change.depth[k - 1]);
    return sum;
  };
  const auto deepest = std::min_element(change.height.begin(), change.height.end());
  const auto at = static_cast<std::size_t>(deepest - change.height.begin()) / across;
  EXPECT_EQ(*deepest, scalar(yielded().plasticity, "deepest_change"));
  EXPECT_NEAR(-*deepest, shortening(at), 0.1 * shortening(at));
  int compared = 0;
  for (std::size_t i = 0; i < change.position.size(); ++i)
    if (change.position[i] > -0.04 && change.position[i] < -0.02) {
      const auto row = change.height.begin() + static_cast<std::ptrdiff_t>(i * across);
      EXPECT_NEAR(-*std::min_element(row, row + static_cast<std::ptrdiff_t>(across)), shortening(i),
                  0.2 * shortening(i))
          << change.position[i];
      ++compared;
    }
  EXPECT_GE(compared, 4);
}

// The material under the largest force, by Hertz: von Mises stress 0.62 p0 below the surface (K. L. Johnson, Contact
// Mechanics, 4.4), if it stayed elastic. It strains at least as much as if its surroundings held it to the elastic
// strain, and, sheared one way and back by a passing wheel, at most twice by Neuber's rule: stress times strain is that
// of the elastic material.
TEST(PlasticRun, StrainsBetweenElasticAndNeuber) {
  const auto& r = yielded();
  ASSERT_TRUE(r.complete);
  const auto& force = *r.signal("contact_force");
  const double p0 = scalar(r.equilibrium, "hertz_peak_pressure") *
                    std::cbrt(*std::max_element(force.begin(), force.end()) / scalar(r.equilibrium, "contact_force"));
  const double young = 210e9, yield = 0.4e9, hardening = young * 21e9 / (young - 21e9), elastic = 0.62 * p0;
  const double strain = scalar(r.plasticity, "largest_equivalent_strain");
  EXPECT_GT(strain, (elastic - yield) / (3 * young / 2.6 + hardening));
  double stress = yield;  // of Neuber's rule, by halving
  for (double low = yield, high = elastic; high - low > 1; stress = 0.5 * (low + high)) {
    const double at = 0.5 * (low + high);
    (at * (at / young + (at - yield) / hardening) < elastic * elastic / young ? low : high) = at;
  }
  EXPECT_LT(strain, 2 * (stress - yield) / hardening);
}

TEST(PlasticRun, LeavesTheRestAlone) {
  const auto& r = yielded();
  // Far from the wheel's path nothing has changed.
  const auto& last = r.snapshots.back();
  EXPECT_EQ(last.name, "unloaded");
  ASSERT_EQ(last.plasticStrain.size(), r.surface.points.size() / 3);
  float far = 0;
  for (std::size_t i = 0; i < last.plasticStrain.size(); ++i)
    if (std::abs(r.surface.points[3 * i]) > 0.15F) far = std::max(far, last.plasticStrain[i]);
  EXPECT_EQ(far, 0.F);
}

// Everything that is a force, a stiffness or a mass twice as large, times and lengths as before: the same run in
// another unit of force. Strain and groove stay, stresses double. Both equilibria are solved until 1e-7 of the weight
// is left, which a few milliseconds of rolling pass on: 5e-6 of the largest value.
TEST(PlasticRun, IsTheSameInAnotherUnitOfForce) {
  const auto doubled = run(softRail({{"rail.young_modulus", "420"},
                                     {"rail.density", "15600"},
                                     {"rail.yield_stress", "0.8"},
                                     {"rail.tangent_modulus", "42"},
                                     {"wheelset.young_modulus", "420"},
                                     {"wheelset.density", "15600"},
                                     {"wheelset.total_mass", "1900"},
                                     {"wheelset.axle_box_mass", "300"},
                                     {"sleeper.young_modulus", "76.8"},
                                     {"sleeper.density", "4900"},
                                     {"pad.stiffness", "2600"},
                                     {"pad.damping", "90"},
                                     {"pad.longitudinal_stiffness", "260"},
                                     {"pad.longitudinal_damping", "9"},
                                     {"pad.lateral_stiffness", "260"},
                                     {"pad.lateral_damping", "9"},
                                     {"ballast.stiffness", "90"},
                                     {"ballast.damping", "64"},
                                     {"ballast.longitudinal_stiffness", "40"},
                                     {"ballast.longitudinal_damping", "28"},
                                     {"ballast.lateral_stiffness", "40"},
                                     {"ballast.lateral_damping", "28"},
                                     {"suspension.sprung_mass", "16000"},
                                     {"suspension.stiffness", "2.3"},
                                     {"suspension.damping", "5"},
                                     {"suspension.longitudinal_stiffness", "40"},
                                     {"suspension.longitudinal_damping", "40"},
                                     {"motion.torque", "24900.98"}}));
  const auto &a = yielded().permanent, &b = doubled.permanent;
  const auto expectTimes = [](double factor, const std::vector<double>& from, const std::vector<double>& to) {
    ASSERT_EQ(from.size(), to.size());
    double maximum = 0, difference = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      maximum = std::max(maximum, std::abs(factor * from[i]));
      difference = std::max(difference, std::abs(to[i] - factor * from[i]));
    }
    EXPECT_GT(maximum, 0);
    EXPECT_LE(difference, 5e-6 * maximum);
  };
  expectTimes(1, a.height, b.height);
  expectTimes(1, a.equivalentStrain, b.equivalentStrain);
  expectTimes(2, a.stressAlong, b.stressAlong);
  expectTimes(1, *yielded().signal("aba"), *doubled.signal("aba"));
}

// The surface that was pressed is left in compression along the rail: it wants to spread and the rail below holds it
// (K. L. Johnson, Contact Mechanics, 9.2), by a share of the yield strength of 400 MPa that round-off or the elastic
// stresses under the wheel, which has gone, would not leave: a twentieth.
TEST(PlasticRun, LeavesTheSurfaceInCompression) {
  const auto& r = yielded();
  EXPECT_LT(scalar(r.plasticity, "largest_residual_compression"), -20e6);
  const auto& change = r.permanent;
  double sum = 0;
  for (std::size_t i = 0; i < change.position.size(); ++i) sum += change.stressAlong[i * change.depth.size()];
  EXPECT_LT(sum, 0);
}

TEST(PlasticRun, EnergyIsAccountedFor) {
  // 0.1 % of the strain energy at the start plus all dissipation, as for the elastic rail. What flow dissipates is ten
  // times the residual at least, so that a balance without it would not close.
  const auto& r = yielded();
  EXPECT_LT(scalar(r.performance, "energy_residual"), 1e-3);
  const auto valuesOf = [&](const char* name) {
    const auto found =
        std::find_if(r.energy.begin(), r.energy.end(), [&](const auto& one) { return one.name == name; });
    return found == r.energy.end() ? std::vector<double>() : found->values;
  };
  const auto plastic = valuesOf("plastic"), residual = valuesOf("residual");
  ASSERT_FALSE(plastic.empty() || residual.empty());
  EXPECT_TRUE(std::is_sorted(plastic.begin(), plastic.end()));
  double largest = 0;
  for (const double value : residual) largest = std::max(largest, std::abs(value));
  EXPECT_GT(plastic.back(), 10 * largest);
}

// Also on another number of threads.
TEST(PlasticRun, StoppedAndResumedIsTheSameToTheBit) {
  const tests::TemporaryFolder folder;
  auto options = plain();
  options.checkpointPath = folder / "run.checkpoint";
  CancelAt half(0.5);
  ASSERT_FALSE(simulation::runCase(softRail(), options, half).complete);
  options.resume = true;
  options.threads = 3;
  EXPECT_EQ(results::firstDifference(comparable(run(softRail(), options)), comparable(yielded())), "");
}

TEST(PlasticRun, ACheckpointWithoutPlasticStrainIsRefused) {
  const tests::TemporaryFolder folder;
  auto options = plain();
  options.checkpointPath = folder / "run.checkpoint";
  CancelAt soon(0.1);
  simulation::runCase(softRail(), options, soon);
  auto tree = *results::readCheckpoint(options.checkpointPath);
  std::erase_if(tree.arrays, [](const auto& array) { return array.path == "/rolling/plastic"; });
  results::writeCheckpoint(options.checkpointPath, tree);
  options.resume = true;
  EXPECT_THROW(run(softRail(), options), FileError);
}

}  // namespace
}  // namespace squat
