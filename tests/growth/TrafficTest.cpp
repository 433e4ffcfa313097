// The wheelsets that stand for the traffic.
#include "growth/Traffic.h"

#include <gmock/gmock.h>

#include <cmath>

#include "growth/SmallRail.h"

namespace squat::growth {
namespace {

scenario::Growth mixed(int wheelsets, int seed) {
  scenario::Growth growth;
  growth.wheelsets = wheelsets, growth.seed = seed;
  growth.lateralScatter = 0.003, growth.loadScatter = 0.2, growth.speedScatter = 0.1;
  growth.traction = 0.01, growth.tractionScatter = 0.05;
  return growth;
}

// Strata are scaled to the standard deviation that is asked for: exact but for round-off.
TEST(GrowthTraffic, MeansAndScatterAreThoseAskedFor) {
  for (const int count : {2, 4, 7, 32}) {
    const auto draws = drawTraffic(mixed(count, 3));
    ASSERT_EQ(draws.size(), static_cast<std::size_t>(count));
    const auto check = [&](double Draw::*value, double mean, double deviation) {
      double sum = 0, squares = 0;
      for (const auto& draw : draws) sum += draw.*value, squares += std::pow(draw.*value - mean, 2);
      EXPECT_NEAR(sum / count, mean, 1e-12);
      EXPECT_NEAR(std::sqrt(squares / count), deviation, 1e-12);
    };
    check(&Draw::lateral, 0, 0.003);
    check(&Draw::load, 1, 0.2);
    check(&Draw::speed, 1, 0.1);
    check(&Draw::traction, 0.01, 0.05);
  }
}

// Mean of the upper half of the normal distribution, sqrt(2/pi), scaled to variance one: two strata stand at -1 and 1;
// of four, the outer ones at phi(0.6745) / 0.25 = 1.2711 and the inner ones at (phi(0) - phi(0.6745)) / 0.25 = 0.3247
// before scaling.
TEST(GrowthTraffic, StrataOfTheNormalDistribution) {
  std::vector<double> lateral;
  for (const auto& draw : drawTraffic(mixed(4, 1))) lateral.push_back(draw.lateral / 0.003);
  const double scale = 1 / std::sqrt(0.5 * (1.2711 * 1.2711 + 0.3247 * 0.3247));
  using ::testing::DoubleNear;
  EXPECT_THAT(lateral,
              ::testing::UnorderedElementsAre(DoubleNear(-1.2711 * scale, 1e-3), DoubleNear(-0.3247 * scale, 1e-3),
                                              DoubleNear(0.3247 * scale, 1e-3), DoubleNear(1.2711 * scale, 1e-3)));
}

TEST(GrowthTraffic, TheSeedDecides) {
  const auto one = drawTraffic(mixed(16, 1)), again = drawTraffic(mixed(16, 1)), other = drawTraffic(mixed(16, 2));
  bool same = true, differs = false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    same = same && one[i].load == again[i].load && one[i].lateral == again[i].lateral;
    differs = differs || one[i].load != other[i].load || one[i].lateral != other[i].lateral;
  }
  EXPECT_TRUE(same);
  EXPECT_TRUE(differs);
}

TEST(GrowthTraffic, AnyWheelsetAloneIsTheMean) {
  const auto draws = drawTraffic(mixed(1, 5));
  EXPECT_EQ(draws.front().lateral, 0);
  EXPECT_EQ(draws.front().load, 1);
  EXPECT_EQ(draws.front().speed, 1);
  EXPECT_DOUBLE_EQ(draws.front().traction, 0.01);
}

// The torque of the case is that of the measuring wheelset: the traffic has its own.
TEST(GrowthTraffic, ADrawChangesTheCase) {
  auto c = tests::growingDefect({{"motion.torque", "9000"}});
  const double mass = axleMass(c);
  EXPECT_DOUBLE_EQ(mass, 2 * (c.suspension.sprungMass + c.wheelset.totalMass));
  const auto drawn = withDraw(c, {0.002, 1.1, 0.9, -0.04});
  EXPECT_DOUBLE_EQ(drawn.motion.lateralOffset, c.motion.lateralOffset + 0.002);
  EXPECT_DOUBLE_EQ(drawn.motion.speed, 0.9 * c.motion.speed);
  EXPECT_DOUBLE_EQ(axleMass(drawn), mass + 0.2 * c.suspension.sprungMass);
  EXPECT_EQ(drawn.motion.torque, 0);
  EXPECT_DOUBLE_EQ(drawn.motion.tractionCoefficient, -0.04);
}

}  // namespace
}  // namespace squat::growth
