#include "forces/ForceShares.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

namespace squat {
namespace {

// Three sleepers with two springs each to the ground and one to the rail, whose places are 10, 11 and 12; sleepers 1
// and 2 share place 11 there.
struct Track {
  forces::ForceElements ballast, pads;

  Track() {
    for (std::size_t sleeper = 0; sleeper < 3; ++sleeper)
      for (std::size_t i = 0; i < 2; ++i)
        add(ballast, {{2 * sleeper + i, 1.0}}, 100.0 + static_cast<double>(sleeper), 3.0 + static_cast<double>(i));
    for (std::size_t sleeper = 0; sleeper < 3; ++sleeper)
      add(pads, {{2 * sleeper, -0.5}, {2 * sleeper + 1, -0.5}, {sleeper == 0 ? 10 : 11, 1.0}}, 1000.0, 20.0);
  }
  static void add(forces::ForceElements& set, const std::vector<std::pair<std::size_t, double>>& terms, double k,
                  double c) {
    set.add(terms, k, c);
    for (const auto& [unknown, weight] : terms) set.forceSlot.push_back(unknown);
  }
  forces::SharedForces shared(int shares, const std::function<int(std::size_t)>& ownerOf) const {
    return forces::shareForces({ballast, pads}, shares, ownerOf);
  }
};

std::vector<double> forcesOf(const forces::SharedForces& shared, const std::vector<double>& u,
                             const std::vector<double>& v, std::vector<double>& dissipation) {
  std::vector<double> result(u.size(), 0.0);
  dissipation.assign(shared.groups, -1.0);
  for (const auto& share : shared.shares)
    forces::addForces(share, u.data(), v.data(), result.data(), dissipation.data());
  return result;
}

std::vector<double> ramp(double first, double step) {
  std::vector<double> values(12);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = first + step * static_cast<double>(i);
  return values;
}

TEST(ForceShares, WhatPushesAtACommonPlaceStaysTogether) {
  std::vector<std::size_t> asked;
  const auto shared =
      Track().shared(2, [&](std::size_t unknown) { return asked.push_back(unknown), unknown < 2 ? 1 : 0; });
  ASSERT_EQ(shared.groups, 2u);                        // the first sleeper; the other two by place 11
  EXPECT_EQ(asked, (std::vector<std::size_t>{0, 2}));  // the first term of each
  EXPECT_EQ(shared.shares[1].elements.size(), 3u);     // two of the ballast, a pad
  EXPECT_EQ(shared.shares[0].elements.size(), 6u);
  EXPECT_EQ(shared.shares[0].groups, std::vector<std::size_t>{1});
  EXPECT_EQ(shared.shares[1].groups, std::vector<std::size_t>{0});
  EXPECT_EQ(shared.shares[0].elements.stiffness, (std::vector<double>{101, 101, 102, 102, 1000, 1000}));  // their order
}

// By hand for the first sleeper: u = (1, 2), u_rail = 11; v = (0, 1), v_rail = 10.
TEST(ForceShares, ForcesAndDissipationAreThoseOfTheElements) {
  const auto shared = Track().shared(3, [](std::size_t unknown) { return unknown < 2 ? 0 : 2; });
  std::vector<double> dissipation;
  const auto f = forcesOf(shared, ramp(1, 1), ramp(0, 1), dissipation);
  const double pad = 1000 * (11 - 1.5) + 20 * (10 - 0.5);
  EXPECT_DOUBLE_EQ(f[10], -pad);
  EXPECT_DOUBLE_EQ(f[0], -(100 * 1.0 + 3 * 0.0) + 0.5 * pad);
  EXPECT_DOUBLE_EQ(f[1], -(100 * 2.0 + 4 * 1.0) + 0.5 * pad);
  EXPECT_DOUBLE_EQ(dissipation[0], 4 * 1.0 * 1.0 + 20 * 9.5 * 9.5);
}

TEST(ForceShares, AnyNumberOfSharesGivesTheSameBits) {
  const auto u = ramp(0.1, 0.37), v = ramp(-1.3, 0.71);
  std::vector<double> dissipation, other;
  const auto one = forcesOf(Track().shared(1, [](std::size_t) { return 0; }), u, v, dissipation);
  for (const int shares : {2, 3}) {
    const auto shared = Track().shared(shares, [&](std::size_t unknown) { return static_cast<int>(unknown) % shares; });
    EXPECT_EQ(forcesOf(shared, u, v, other), one);
    EXPECT_EQ(other, dissipation);
  }
}

}  // namespace
}  // namespace squat
