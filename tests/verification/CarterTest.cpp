// A cylinder rolls on a plane with longitudinal creepage in plane strain: force and stick zone.
// Theory: F. W. Carter 1926; K. L. Johnson, Contact Mechanics (1985), 8.3: for two bodies of one material, half length
// a of the patch, a^2 = 4 P R / pi E*, the stick zone lies at the leading edge and has the half length
//   a' = a sqrt(1 - F / mu P),   creepage = mu a / R (1 - sqrt(1 - F / mu P)).
// (CONTACT's example carter2d: R 500 mm, a = 1 mm, mu 0.3, creepage 2.4e-4: F = 0.64 mu P, a' = 0.6 mm.)
// Tolerances: the larger of 0.01 and 5 % for F / mu P, 8 % for the stick zone, whose ends fall between points 0.65 mm
// apart; elements of 1.3 mm, eleven along the patch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "elasticity/SweptSamples.h"
#include "verification/CreepForce.h"
#include "verification/Seen.h"

namespace squat::contact {
namespace {

TEST(Carter, ForceAndStickZoneOfARollingCylinder) {
  RolledCase with;
  with.plane = true;
  const double line = 1e7;  // [N/m]
  const double modulus = elasticity::steel.young / (2 * (1 - elasticity::steel.poisson * elasticity::steel.poisson));
  with.load = line * with.size;
  with.halfAxis = std::sqrt(4 * line * with.radius / (std::acos(-1.0) * modulus));
  const double scale = with.friction * with.halfAxis / with.radius;
  CreepCurve curve(with);
  for (const double share : {0.36, 0.64, 0.84}) {
    const double creepage = scale * (1 - std::sqrt(1 - share));
    const auto found = curve.settle(creepage);
    const double stick = 2 * with.halfAxis * std::sqrt(1 - found.share);
    std::printf("  creepage %.2e  F / mu P %.4f  Carter %.4f  stick %.2f mm  Carter %.2f mm (%+.1f %%)\n", creepage,
                found.share, share, 1e3 * found.stick, 1e3 * stick, 100 * (found.stick / stick - 1));
    EXPECT_NEAR(found.share, share, std::max(0.01, 0.05 * share));
    verification::seenDeviation("force", found.share, share);
    EXPECT_NEAR(found.stick, stick, 0.08 * stick);
    verification::seenDeviation("stick length", found.stick, stick);
    // A semi-ellipse of pressure: <x^2> = a^2 / 4.
    EXPECT_NEAR(found.length, std::sqrt(5.0) * with.halfAxis, 0.03 * std::sqrt(5.0) * with.halfAxis);
  }
}

}  // namespace
}  // namespace squat::contact
