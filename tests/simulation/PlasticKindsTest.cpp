// Kinds of plastic rails beside each other, whole runs.
#include <algorithm>
#include <cmath>

#include "simulation/PlasticRun.h"

namespace squat {
namespace {

using tests::run;
using tests::scalar;
using tests::softRail;
using tests::yielded;

// A yield stress that nothing reaches: the elastic run, but for round-off.
TEST(PlasticKinds, WithoutYieldItIsTheElasticRun) {
  const auto hard = run(softRail({{"rail.yield_stress", "10"}, {"mesh.precision", "double"}}));
  const auto elastic = run(softRail({{"rail.plastic", "false"}, {"mesh.precision", "double"}}));
  ASSERT_EQ(hard.signals.size(), elastic.signals.size());
  // Nodes of the layer have lines of outer forces, and so their inverse masses as such, not as products: they differ by
  // round-off, 1e-16, which 1e4 steps and contact that opens and closes carry on.
  for (std::size_t c = 0; c < hard.signals.size(); ++c) {
    const auto &with = hard.signals[c].values, &without = elastic.signals[c].values;
    ASSERT_EQ(with.size(), without.size());
    double largest = 0, different = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
      largest = std::max(largest, std::abs(without[i]));
      different = std::max(different, std::abs(with[i] - without[i]));
    }
    EXPECT_LT(different, 1e-9 * largest) << elastic.signals[c].name;
  }
  EXPECT_EQ(scalar(hard.plasticity, "largest_equivalent_strain"), 0);
  EXPECT_TRUE(elastic.plasticity.empty());
  EXPECT_TRUE(elastic.permanent.empty());
}

// Nodes moved into the defect's shape take their own elements along. 0.15 mm over layers of 20 mm change little: the
// plastic strain differs by less than a tenth.
TEST(PlasticKinds, MovedNodesYieldAlike) {
  const auto moved = run(softRail({{"defect.move_nodes", "true"}}));
  const double there = scalar(moved.plasticity, "largest_equivalent_strain");
  const double here = scalar(yielded().plasticity, "largest_equivalent_strain");
  EXPECT_NEAR(there, here, 0.1 * here);
  EXPECT_NE(there, here);
}

TEST(PlasticKinds, KinematicHardeningFlowsOtherwise) {
  const auto kinematic = run(softRail({{"rail.hardening", "kinematic"}}));
  EXPECT_LT(scalar(kinematic.performance, "energy_residual"), 2e-3);
  EXPECT_NE(scalar(kinematic.plasticity, "largest_equivalent_strain"),
            scalar(yielded().plasticity, "largest_equivalent_strain"));
}

}  // namespace
}  // namespace squat
