// Receptance of the solid track: ten metres against a Timoshenko beam (TrackReceptanceTest.cpp has theory and
// tolerances), and nearly rigid sleepers against published numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "verification/ReceptanceComparison.h"
#include "verification/Seen.h"

namespace squat::verification {
namespace {

TEST(TrackReceptanceLong, TenMetresAreThoseOfABeam) {
  compareWithBeam(cases::loadCase(tests::fixtureCase("smooth-rail"), {"draft", {}}), 5);
}

// Nearly rigid sleepers on short pads, long track, against numbers of a Timoshenko model made apart from this program:
// 54E1, 25 mm elements, shear coefficient 0.40, density 7800 kg/m3, 100 bays, point supports, half sleeper 122 kg
// rigid, pads 1300 MN/m and 45 kN s/m, ballast 45 MN/m and 32 kN s/m. Receptance [m/N].
struct Published {
  double frequency, overSleeper, midspan;
};
constexpr Published kPublished[] = {
    {50, 1.295e-8, 1.337e-8},   {82, 2.020e-8, 2.044e-8},    {100, 1.460e-8, 1.454e-8},   {300, 2.475e-9, 5.737e-10},
    {1000, 1.030e-9, 1.089e-8}, {1018, 8.605e-10, 4.306e-8}, {2000, 3.994e-10, 2.615e-10}};
constexpr double kFullTrack = 82, kPinPin = 1018;  // [Hz]

TEST(TrackReceptanceLong, RigidSleepersGiveThePublishedNumbers) {
  auto d =
      cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny", {{"track.length", "30"}, {"pad.length", "0.02"}}});
  d.sleeper.material.young = 2e12;
  d.pad.longitudinalStiffness = d.pad.longitudinalDamping = 0;
  const auto solid = solidTrack(d);
  ASSERT_EQ(solid.points.size(), 2u);
  double worst = 0;
  const auto expectLevel = [&](const receptance::PointReceptance& point, double frequency, double expected) {
    const double off = levelDifference(solid, point.receptance, frequency, 20 * std::log10(expected));
    EXPECT_LT(off, kDecibels) << point.name << ", " << frequency << " Hz";
    worst = std::max(worst, off);
  };
  for (const auto& row : kPublished) {
    expectLevel(solid.points[0], row.frequency, row.overSleeper);
    // The height of the pin-pin peak hangs on the damping of a few bays: not a level away from resonances.
    if (row.frequency != kPinPin) expectLevel(solid.points[1], row.frequency, row.midspan);
  }
  // Once a shift by 4 % is allowed for, most levels do not differ: a tenth of a decibel counts as none.
  seen("levels", std::max(0.1, worst), "dB");
  const auto expectResonance = [&](const receptance::PointReceptance& point, double f) {
    double nearest = 0;
    for (const double found : receptance::resonances(solid.frequency, point.receptance))
      if (std::abs(found - f) < std::abs(nearest - f)) nearest = found;
    EXPECT_NEAR(nearest, f, kShift * f) << point.name;
    seenDeviation("resonances", nearest, f);
  };
  expectResonance(solid.points[0], kFullTrack);
  expectResonance(solid.points[1], kFullTrack);
  expectResonance(solid.points[1], kPinPin);
}

}  // namespace
}  // namespace squat::verification
