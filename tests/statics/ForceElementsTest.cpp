// Force elements of the assembled model at rest: progressive pads, seats that differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "statics/Equilibrium.h"

namespace squat::statics {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

model::Model tinyModel(const Values& values) {
  return model::buildModel(cases::loadScenario("smooth-rail", {"tiny", values}));
}

Equilibrium equilibriumOf(const model::Model& model) {
  ThreadTeam team(1);
  Monitor quiet;
  return findEquilibrium(model, elasticity::kernelsFor(""), team, model.startX, 0, {}, quiet);
}

double largest(const AlignedVector& values) {
  double maximum = 0;
  for (const double v : values) maximum = std::max(maximum, std::abs(v));
  return maximum;
}

// A curve whose points lie on one line is the linear pad: 1300 kN/mm.
TEST(ProgressivePad, StraightCurveIsTheLinearPad) {
  const auto linear = tinyModel({}), curved = tinyModel({{"pad.curve", "[[0, 0], [0.02, 26], [1, 1300]]"}});
  const auto a = equilibriumOf(linear), b = equilibriumOf(curved);
  // Both leave 1e-7 of the load, some nanometres on 45 MN/m, and stop at different iterates.
  ASSERT_EQ(a.displacement.size(), b.displacement.size());
  const double maximum = largest(a.displacement);
  for (std::size_t i = 0; i < a.displacement.size(); ++i)
    ASSERT_NEAR(a.displacement[i], b.displacement[i], 1e-5 * maximum) << i;
  EXPECT_NEAR(b.strainEnergy, a.strainEnergy, 1e-5 * a.strainEnergy);
}

// 300 kN/mm up to 15 kN, then 1000 kN/mm. Each spring of each pad has a twenty-fourth of the curve's force, and all
// pads together carry rail, wheelset and sprung mass; those under the wheel stand on the second slope.
TEST(ProgressivePad, PadsCarryTheWeightByTheirCurve) {
  const auto model = tinyModel({{"pad.curve", "[[0, 0], [0.05, 15], [0.15, 115]]"}});
  const auto e = equilibriumOf(model);
  EXPECT_LT(e.residual, 1e-7);
  const auto curve = [](double c) { return c < 0.05e-3 ? 300e6 * c : 15e3 + 1000e6 * (c - 0.05e-3); };
  double sum = 0, stiffest = 0;
  std::size_t springs = 0;
  for (const auto& set : model.forceElements) {
    if (set.kind != forces::Kind::railPad || !set.law) continue;
    springs += set.size();
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double q = set.elongation(i, e.displacement.data()), expected = curve(-q) / 24;
      sum += expected;
      EXPECT_NEAR(-set.elasticForce(i, q), expected, 1e-9 * 15e3);
      stiffest = std::max(stiffest, 24 * set.tangent(i, q));
    }
  }
  EXPECT_EQ(springs, 24u * static_cast<std::size_t>(model.sleepers));
  EXPECT_NEAR(stiffest, 1000e6, 1);
  double rail = 0;
  const auto& block = model.blocks[model.rail];
  for (int n = 0; n < block.nodes; ++n)
    for (int s = 0; s < block.stationCount; ++s) rail += model.mass[model.rail][n * block.stride + s];
  const auto& d = model.scenario;
  const double load = d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass + rail);
  EXPECT_NEAR(sum, load, 1e-5 * load);
}

// Only the seats that are named differ, by what is named; they count from the sleeper nearest to the defect.
TEST(Seats, DifferByWhatTheySay) {
  const Values moved{{"track.defect_from_sleeper", "0.2"}};
  auto named = moved;
  named.push_back({"track.seats",
                   "[{ sleeper = 0, pad_stiffness = 650, pad_damping = 9 }, { sleeper = -1, "
                   "ballast_stiffness = 15, ballast_damping = 8 }]"});
  const auto plain = tinyModel(moved), other = tinyModel(named);
  ASSERT_EQ(plain.forceElements.size(), other.forceElements.size());
  std::map<std::pair<int, forces::Kind>, int> changed;  // per sleeper
  for (std::size_t k = 0; k < plain.forceElements.size(); ++k) {
    const auto &a = plain.forceElements[k], &b = other.forceElements[k];
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a.stiffness[i] == b.stiffness[i] && a.damping[i] == b.damping[i]) continue;
      const bool isPad = a.kind == forces::Kind::railPad;
      const int sleeper = static_cast<int>(i * static_cast<std::size_t>(plain.sleepers) / a.size());
      ++changed[{sleeper, a.kind}];
      EXPECT_NEAR(b.stiffness[i] / a.stiffness[i], isPad ? 650.0 / 1300 : 15.0 / 45, 1e-12);
      EXPECT_NEAR(b.damping[i] / a.damping[i], isPad ? 9.0 / 45 : 8.0 / 32, 1e-12);
    }
  }
  ASSERT_EQ(changed.size(), 2u);
  for (const auto& [at, count] : changed) {
    const bool isPad = at.second == forces::Kind::railPad;
    // The defect lies 0.2 m behind the sleeper that is nearest to it in rolling direction.
    EXPECT_NEAR(plain.sleeperPositions[static_cast<std::size_t>(at.first)], isPad ? -0.2 : -0.8, 1e-9);
    const auto& sleeper = plain.blocks[plain.firstSleeper];
    if (isPad) {
      EXPECT_EQ(count, 24);
    } else {
      EXPECT_EQ(count % sleeper.stationCount, 0);  // all along it
    }
  }
}

}  // namespace
}  // namespace squat::statics
