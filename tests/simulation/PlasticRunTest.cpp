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

using testing::CancelAt;
using testing::comparable;
using testing::plain;
using testing::run;
using testing::scalar;
using testing::softRail;
using testing::yielded;

TEST(PlasticRun, LeavesItsMark) {
  const auto& r = yielded();
  ASSERT_TRUE(r.complete);
  // More than the yield strain, 0.4 / 210, and less than a hundredth.
  const double strain = scalar(r.plasticity, "largest_equivalent_strain");
  EXPECT_GT(strain, 0.0019);
  EXPECT_LT(strain, 0.01);
  // The wheel presses a groove: micrometres, less than the whole approach of the bodies (about 0.1 mm).
  const double deepest = scalar(r.plasticity, "deepest_change");
  EXPECT_LT(deepest, -0.2e-6);
  EXPECT_GT(deepest, -1e-4);
  ASSERT_EQ(r.permanent.height.size(), r.permanent.position.size() * r.permanent.lateral.size());
  EXPECT_EQ(*std::min_element(r.permanent.height.begin(), r.permanent.height.end()), deepest);
  // Far from the wheel's path nothing has changed.
  const auto& last = r.snapshots.back();
  EXPECT_EQ(last.name, "unloaded");
  ASSERT_EQ(last.plasticStrain.size(), r.surface.points.size() / 3);
  float far = 0;
  for (std::size_t i = 0; i < last.plasticStrain.size(); ++i)
    if (std::abs(r.surface.points[3 * i]) > 0.15F) far = std::max(far, last.plasticStrain[i]);
  EXPECT_EQ(far, 0.F);
}

// The surface that was pressed is left in compression along the rail: it wants to spread and the rail below holds it
// (K. L. Johnson, Contact Mechanics, 9.2).
TEST(PlasticRun, LeavesTheSurfaceInCompression) {
  const auto& r = yielded();
  EXPECT_LT(scalar(r.plasticity, "largest_residual_compression"), -20e6);
  const auto& change = r.permanent;
  double sum = 0;
  for (std::size_t i = 0; i < change.position.size(); ++i) sum += change.stressAlong[i * change.depth.size()];
  EXPECT_LT(sum, 0);
}

TEST(PlasticRun, EnergyIsAccountedFor) {
  // 0.1 % of the strain energy at the start plus all dissipation, as for the elastic rail; what flow dissipates is far
  // above that, so that a term left out would show.
  const auto& r = yielded();
  EXPECT_LT(scalar(r.performance, "energy_residual"), 1e-3);
  for (const auto& channel : r.energy)
    if (channel.name == "plastic") {
      EXPECT_GT(channel.values.back(), 0.1);
      EXPECT_TRUE(std::is_sorted(channel.values.begin(), channel.values.end()));
    }
}

// Also on another number of threads.
TEST(PlasticRun, StoppedAndResumedIsTheSameToTheBit) {
  const testing::TemporaryFolder folder;
  auto options = plain();
  options.checkpointPath = folder / "run.checkpoint";
  CancelAt half(0.5);
  ASSERT_FALSE(simulation::runCase(softRail(), options, half).complete);
  options.resume = true;
  options.threads = 3;
  EXPECT_EQ(results::firstDifference(comparable(run(softRail(), options)), comparable(yielded())), "");
}

TEST(PlasticRun, ACheckpointWithoutPlasticStrainIsRefused) {
  const testing::TemporaryFolder folder;
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
