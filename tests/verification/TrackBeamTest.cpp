// The beam model of the track itself (TrackBeam.h), against numbers of a Timoshenko model made apart from this program:
// 54E1 (69.77 cm2, 2337.9 cm4), 25 mm elements, shear coefficient 0.40, density 7800 kg/m3, 100 bays of 0.6 m, point
// supports, half sleeper 122 kg rigid, pads 1300 MN/m and 45 kN s/m, ballast 45 MN/m and 32 kN s/m.
// Sleepers are next to rigid here.
// Tolerances: the equations are the same, so 2 % of the magnitude and 2 degrees; 5 % about the pin-pin resonance, where
// 0.1 % of the frequency is 1.5 % of the magnitude; 0.5 % of a resonance's frequency, 1 Hz where that is less. The
// published row at 1018 Hz stands on the pin-pin peak, where 1 Hz is a factor of two: its frequency alone is compared.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "verification/Seen.h"
#include "verification/TrackBeam.h"

namespace squat::verification {
namespace {

constexpr double midspan = 0.3;

TrackBeam hundredBays() {
  auto d = cases::loadScenario(tests::fixtureCase("smooth-rail"));
  d.track.length = 60;
  d.pad.length = 1e-7, d.pad.longitudinalStiffness = 0, d.pad.longitudinalDamping = 0;
  d.sleeper.material.young = 1e16;
  std::vector<double> sleepers;
  for (int i = -50; i <= 50; ++i) sleepers.push_back(0.6 * i);
  return TrackBeam(d, {69.77e-4, 2337.9e-8, 0.0751}, -30, sleepers);
}

const TrackBeam& beam() {
  static const TrackBeam model = hundredBays();
  return model;
}

struct Row {
  double frequency;
  double magnitude[2], phase[2];  // over a sleeper, midspan: [m/N], [deg]
  double tolerance[2];            // share of the magnitude
};
constexpr Row published[] = {
    {50, {1.295e-8, 1.337e-8}, {-14, -13}, {0.02, 0.02}},    {82, {2.020e-8, 2.044e-8}, {-56, -55}, {0.02, 0.02}},
    {100, {1.460e-8, 1.454e-8}, {-94, -93}, {0.02, 0.02}},   {300, {2.475e-9, 5.737e-10}, {-131, -104}, {0.02, 0.02}},
    {1000, {1.030e-9, 1.089e-8}, {-128, -78}, {0.02, 0.05}}, {2000, {3.994e-10, 2.615e-10}, {-92, -133}, {0.02, 0.02}}};

TEST(TrackBeam, HasThePublishedReceptance) {
  for (const auto& row : published) {
    const auto found = beam().receptance({0, midspan}, row.frequency);
    for (int p = 0; p < 2; ++p) {
      EXPECT_NEAR(std::abs(found[p]), row.magnitude[p], row.tolerance[p] * row.magnitude[p]) << row.frequency << " Hz";
      seenDeviation(row.tolerance[p] > 0.02 ? "beside pin-pin" : "magnitude", std::abs(found[p]), row.magnitude[p]);
      EXPECT_NEAR(std::arg(found[p]) * 180 / std::acos(-1.0), row.phase[p], 2) << row.frequency << " Hz";
    }
  }
}

TEST(TrackBeam, HasThePublishedDeflectionAtRest) {
  EXPECT_NEAR(-beam().deflection(0, 0, 1, false), 1.000e-8, 0.005e-8);
  EXPECT_NEAR(-beam().deflection(midspan, midspan, 1, false), 1.045e-8, 0.005e-8);
}

// The magnitude is larger (sign +1) or smaller (-1) at a frequency than `width` [Hz] beside it.
void expectExtreme(double x, double frequency, int sign, double width) {
  double level[3];
  for (const int i : {0, 1, 2}) level[i] = sign * std::abs(beam().receptance({x}, frequency + width * (i - 1))[0]);
  EXPECT_GT(level[1], level[0]) << frequency << " Hz";
  EXPECT_GT(level[1], level[2]) << frequency << " Hz";
}

TEST(TrackBeam, HasThePublishedResonances) {
  expectExtreme(0, 82, 1, 1);          // whole track on the ballast; told in full hertz
  expectExtreme(0, 532, -1, 2);        // sleeper between pad and ballast
  expectExtreme(midspan, 324, -1, 2);  // neighbouring sleepers in antiphase
  expectExtreme(0, 944, 1, 4);         // rail on the pads
  expectExtreme(midspan, 1018, 1, 4);  // pin-pin
}

}  // namespace
}  // namespace squat::verification
