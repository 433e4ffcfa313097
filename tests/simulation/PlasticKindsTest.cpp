// Kinds of plastic rails beside each other, whole runs.
#include "simulation/PlasticRun.h"

namespace squat {
namespace {

using testing::run;
using testing::scalar;
using testing::softRail;
using testing::yielded;

// A yield stress that nothing reaches: the elastic run, to the bit.
TEST(PlasticKinds, WithoutYieldItIsTheElasticRun) {
  const auto hard = run(softRail({{"rail.yield_stress", "10"}}));
  const auto elastic = run(softRail({{"rail.plastic", "false"}}));
  ASSERT_EQ(hard.signals.size(), elastic.signals.size());
  for (std::size_t c = 0; c < hard.signals.size(); ++c) EXPECT_EQ(hard.signals[c].values, elastic.signals[c].values);
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
