// Sums over all nodes against motions whose energy is known.
#include "simulation/EnergySums.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"

namespace squat::simulation {
namespace {

class EnergySumsTest : public testing::Test {
 protected:
  std::unique_ptr<dynamics::Rolling> rolling(ThreadTeam& team, const AlignedVector& velocity) {
    auto rolling = std::make_unique<dynamics::Rolling>(model_, elasticity::kernelsFor(""), team, 1e-7, 0);
    rolling->start(AlignedVector(model_.stateSize, 0.0), velocity, 0);
    return rolling;
  }
  // All nodes of a block move by `value` in its component `c`.
  AlignedVector moved(int block, int c, double value) const {
    AlignedVector state(model_.stateSize, 0.0);
    const auto& b = model_.blocks[static_cast<std::size_t>(block)];
    for (int n = 0; n < b.nodes; ++n)
      for (int s = 0; s < b.stationCount; ++s) state[b.index(n, c, s)] = value;
    return state;
  }
  double massOf(int block) const {
    const auto& b = model_.blocks[static_cast<std::size_t>(block)];
    double sum = 0;
    for (int n = 0; n < b.nodes; ++n)
      for (int s = 0; s < b.stationCount; ++s)
        sum += model_.mass[static_cast<std::size_t>(block)]
                          [static_cast<std::size_t>(n) * b.stride + static_cast<std::size_t>(s)];
    return sum;
  }
  AlignedVector random() const {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> any(-1e-5, 1e-5);
    AlignedVector state(model_.stateSize);
    for (double& value : state) value = any(generator);
    return state;
  }
  model::Model model_ =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"motion.torque", "0"}}}));
  ThreadTeam team_{2};
};

// A wheelset that moves sideways at 2 m/s has the energy m v^2 / 2 and no momentum along the track. Only the wheelset
// moves, since ends of the rail are fixed. 1e-9 is far above the round-off of some ten thousand terms.
TEST_F(EnergySumsTest, MotionSidewaysHasItsKineticEnergy) {
  auto velocity = moved(model_.body, 2, 2.0);
  const auto rim = moved(model_.rim, 2, 2.0);
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += rim[i];
  for (const auto unknown : model_.fixed) ASSERT_EQ(velocity[unknown], 0) << "moves what is fixed";
  const auto moving = rolling(team_, velocity);
  EnergySums sums(*moving);
  const auto motion = sums.motion(*moving);
  const double mass = massOf(model_.body) + massOf(model_.rim);
  EXPECT_NEAR(motion.energy, 0.5 * mass * 4, 1e-9 * mass);
  EXPECT_NEAR(motion.momentum, 0, 1e-9 * mass);
}

// A rail that sinks by a millimetre: the weight does the work m g h, and nothing is strained. Stiffnesses of some
// 1e10 N/m times (1 mm)^2 are 1e4 J a term, of which round-off leaves 1e-12 J: 1e-6 J for all terms is wide.
TEST_F(EnergySumsTest, SinkingDoesTheWorkOfItsWeightAndStrainsNothing) {
  const auto still = rolling(team_, AlignedVector(model_.stateSize, 0.0));
  EnergySums sums(*still);
  ASSERT_EQ(model_.blocks[model_.rail].lean, 0) << "z is the rail's third component only where it stands upright";
  auto sunk = moved(model_.rail, 2, -1e-3);
  EXPECT_NEAR(sums.workOfWeight(*still, sunk), massOf(model_.rail) * model_.scenario.motion.gravity * 1e-3,
              1e-9 * massOf(model_.rail));
  EXPECT_NEAR(sums.quadratic(*still, sunk).rail, 0, 1e-6);
}

TEST_F(EnergySumsTest, StrainEnergyGrowsWithTheSquare) {
  const auto still = rolling(team_, AlignedVector(model_.stateSize, 0.0));
  EnergySums sums(*still);
  auto once = random(), twice = once;
  for (double& value : twice) value *= 2;
  const auto one = sums.quadratic(*still, once), two = sums.quadratic(*still, twice);
  for (const auto& [small, large] :
       {std::pair{one.rail, two.rail}, {one.wheelset, two.wheelset}, {one.sleepers, two.sleepers}}) {
    EXPECT_GT(small, 0);
    EXPECT_NEAR(large, 4 * small, 1e-12 * large);
  }
}

TEST_F(EnergySumsTest, SameBitsForAnyNumberOfThreads) {
  std::vector<double> numbers;
  for (const int threads : {1, 2, 3}) {
    ThreadTeam team(threads);
    const auto moving = rolling(team, random());
    EnergySums sums(*moving);
    auto state = random();
    const auto motion = sums.motion(*moving);
    const double fall = sums.workOfWeight(*moving, state);
    const auto solids = sums.quadratic(*moving, state);
    const std::vector<double> found{motion.energy, motion.momentum, fall,
                                    solids.rail,   solids.wheelset, solids.sleepers};
    if (numbers.empty()) numbers = found;
    EXPECT_EQ(found, numbers) << threads << " threads";
  }
}

}  // namespace
}  // namespace squat::simulation
