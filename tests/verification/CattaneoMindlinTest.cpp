// A pressed contact shifted sideways, partial slip.
// Theory: C. Cattaneo 1938, R. D. Mindlin 1949; K. L. Johnson, Contact Mechanics (1985), 7.2: under the load P and the
// tangential force Q < mu P a circle of radius c sticks and a ring slips,
//   c = a (1 - Q / mu P)^(1/3),  shift = 3 mu P (2 - nu) / 8 a G (1 - (1 - Q / mu P)^(2/3))  for two equal bodies.
// The tangential penalty adds its own share, mean traction of the stick zone over k_t, which is taken off.
// Tolerance 5 % for the shift; the stick radius 8 %: its edge falls between Gauss points, 0.65 mm apart.
#include <gtest/gtest.h>

#include <cmath>

#include "verification/PressedSphere.h"
#include "verification/Seen.h"

namespace squat::elasticity {
namespace {

TEST(CattaneoMindlin, ShiftOfAPressedContact) {
  PressedCase with;
  PressedSphere sphere(with);
  sphere.press();
  const double grip = with.friction * with.load();
  const auto theory = [&](double force) {
    return 3 * grip * (2 - steel.poisson) / (8 * with.halfAxis * with.shearModulus()) *
           (1 - std::pow(1 - force / grip, 2.0 / 3));
  };
  for (const double share : {0.3, 0.6}) {
    const auto found = sphere.shift(theory(share * grip), share * grip, 4);
    EXPECT_NEAR(found.force, share * grip, 0.1 * share * grip);
    const double bodies = theory(share * grip) - found.penaltyShare;
    EXPECT_NEAR(bodies, theory(found.force), 0.05 * theory(found.force)) << "Q / mu P " << share;
    verification::seenDeviation("shift", bodies, theory(found.force));
    const double stick = with.halfAxis * std::cbrt(1 - found.force / grip);
    EXPECT_NEAR(found.stickRadius, stick, 0.08 * stick) << "Q / mu P " << share;
    verification::seenDeviation("stick radius", found.stickRadius, stick);
  }
  // Beyond the grip everything slides.
  const auto sliding = sphere.shift(1.5 * theory(grip), grip, 4);
  EXPECT_NEAR(sliding.force, grip, 1e-3 * grip);
  EXPECT_EQ(sliding.stickRadius, 0);
}

}  // namespace
}  // namespace squat::elasticity
