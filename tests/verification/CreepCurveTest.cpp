// Steady rolling with longitudinal creepage: wheel R 0.46 m on the crown R300, 87.8 kN, friction 0.3, elements of
// 1.3 mm, the shipped penalties.
// Expected F / mu N: computed with the open-source CONTACT 25.2 (E. A. H. Vollebregt), 60 x 60 elements, E 210 GPa, nu
// 0.3, half spaces of one material. Theory: J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990).
// Creepage counts from that of free rolling, some 3e-5: a curved wheel yields to pressure a little otherwise than a
// flat rail, a term of the order (a / R)^2 that half spaces do not have.
// Tolerance: the larger of 0.01 and 5 %, eleven elements along the patch and eight across; below CONTACT nowhere by
// more than 0.05, the shortfall that a tangential penalty brings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "verification/CreepForce.h"
#include "verification/Seen.h"

namespace squat::contact {
namespace {

TEST(CreepCurve, ShippedPenaltyAgainstContact) {
  CreepCurve curve({});
  double shortfall = 0;
  for (const auto& expected : creepForces) {
    const double share = curve.at(expected.creepage);
    std::printf("  creepage %.0e  F / mu N %.4f  CONTACT %.4f  %+.4f\n", expected.creepage, share, expected.share,
                share - expected.share);
    EXPECT_NEAR(share, expected.share, std::max(0.01, 0.05 * expected.share)) << expected.creepage;
    verification::seenDeviation("force", share, expected.share);
    shortfall = std::max(shortfall, expected.share - share);
  }
  std::printf("  free rolling at creepage %.1e, shortfall %.4f\n", curve.freeCreepage(), shortfall);
  EXPECT_LT(shortfall, 0.05);
  EXPECT_LT(std::abs(curve.freeCreepage()), 1e-4);
}

}  // namespace
}  // namespace squat::contact
