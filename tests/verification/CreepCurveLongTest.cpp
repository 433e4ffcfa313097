// Steady rolling with longitudinal creepage as the penalties become rigid: wheel R 0.46 m on the crown R300, 87.8 kN,
// friction 0.3, elements of 1.3 mm.
// Expected F / mu N: CONTACT 25.2, see CreepForce.h. Theory: J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling
// Contact (1990). A penalty k leaves a compliance 1/k, so that the force is extrapolated along the least-squares line
// in 1/k. Tolerance: the larger of 0.01 and 5 %, eleven elements along the patch and eight across. The initial slope of
// CONTACT's curve, from its forces at 1e-4 and 2e-4 (0.0500 and 0.0984) by a parabola: 508.
//
// The pressure has to become rigid with the traction. Under the shipped normal penalty, 2.5 E/h, a rigid tangential one
// gives up to 10 % more force (7 % at 5e-4) in the solid and 5 % in plane strain: traction that yields to nothing acts
// on a patch that a soft layer has widened.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "verification/CreepForce.h"
#include "verification/Seen.h"

namespace squat::contact {
namespace {

constexpr double initialSlope = 508;

struct Softness {
  double normal = 0, tangential = 0;  // penalties in units of E / size
};

struct Curve {
  std::array<double, 6> share;  // at the six creepages of CreepForce.h
  double slope = 0;
};

Curve creepCurve(const Softness& with) {
  RolledCase rolled;
  rolled.normalPenalty = with.normal, rolled.tangentialShare = with.tangential / with.normal;
  CreepCurve curve(rolled);
  Curve found;
  found.slope = curve.slope();
  for (std::size_t i = 0; i < 6; ++i) found.share[i] = curve.at(creepForces[i].creepage);
  return found;
}

// Value at 1/k = 0 of the least-squares line through the values.
double rigid(const std::vector<Softness>& penalties, const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double meanX = 0, meanY = 0, xy = 0, xx = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    meanX += 1 / penalties[i].tangential / count, meanY += values[i] / count;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = 1 / penalties[i].tangential - meanX;
    xy += x * (values[i] - meanY), xx += x * x;
  }
  return meanY - meanX * xy / xx;
}

void expectRigidLimit(const std::string& name, const std::vector<Softness>& penalties, double slopeWithin) {
  std::vector<Curve> curves;
  for (const auto& with : penalties) curves.push_back(creepCurve(with));
  const auto along = [&](const auto& valueOf) {
    std::vector<double> values;
    for (const auto& curve : curves) values.push_back(valueOf(curve));
    return values;
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& expected = creepForces[i];
    const auto values = along([i](const Curve& curve) { return curve.share[i]; });
    const double share = rigid(penalties, values);
    std::printf("  creepage %.0e  F / mu N %.4f %.4f %.4f, rigid %.4f  CONTACT %.4f  %+.1f %%\n", expected.creepage,
                values[0], values[1], values[2], share, expected.share, 100 * (share / expected.share - 1));
    EXPECT_NEAR(share, expected.share, std::max(0.01, 0.05 * expected.share)) << expected.creepage;
    verification::seenDeviation(name + ": force", share, expected.share);
  }
  const double slope = rigid(penalties, along([](const Curve& curve) { return curve.slope; }));
  std::printf("  slope at free rolling %.0f  CONTACT %.0f\n", slope, initialSlope);
  EXPECT_NEAR(slope, initialSlope, slopeWithin * initialSlope);
}

TEST(CreepCurveLong, BothPenaltiesToRigid) { expectRigidLimit("both penalties", {{2.5, 2.5}, {5, 5}, {10, 10}}, 0.05); }

TEST(CreepCurveLong, TangentialPenaltyToRigid) {
  expectRigidLimit("tangential penalty", {{10, 10}, {10, 20}, {10, 40}}, 0.08);
}

}  // namespace
}  // namespace squat::contact
