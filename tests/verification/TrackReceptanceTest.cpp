// Receptance of the solid track against a Timoshenko beam on the same supports.
// Theory: rail as a Timoshenko beam (shear coefficient 0.40), pads over their footprint, bending and twisting half
// sleepers on ballast (TrackBeam.h), solved directly at every frequency; the solid's force is spread over 10 x 10 mm of
// the head and its section's mean displacement read, because the head gives way 6e-10 m/N under the force, as much as
// the whole track at 2 kHz.
// A beam's section keeps its shape; the real foot bends over the pad and the web is squeezed, which takes 13 % of the
// pad's stiffness. That flexibility, 1.8e-11 m2/N, comes from a slice of the rail in plane strain computed by itself
// (SectionFlexibility.h) and stands in series with the beam's pads. Without it the beam lies 4.5 dB off at 900 Hz.
// Tolerances: 4 % of a resonance's frequency; 1.5 dB of the level farther than 4 % from the beam's resonances, once a
// shift of 4 % is allowed for: the sleepers of the solid are coarse, and web and foot pass the load on along the rail.
// Levels away from resonances hardly feel the dampers; phases do: 8 degrees, with the same shift (4.1 seen here, 6.9 on
// ten metres to 2000 Hz; half the pads' damping in the solid alone gives 14, half as much again 11, seven tenths of the
// ballast's 9).
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "verification/ReceptanceComparison.h"

namespace squat::verification {
namespace {

// Three metres, to 1200 Hz, with fewer section shapes: seconds. 50 to 2000 Hz on ten metres is the slow test.
TEST(TrackReceptance, ShortTrackIsThatOfABeam) {
  receptance::ReceptanceOptions options;
  options.highest = 1200;
  options.shapeTolerance = 2e-2;
  options.accuracy = 0.02;
  compareWithBeam(cases::loadCase(tests::fixtureCase("smooth-rail"), {"draft", {{"track.length", "3"}}}), 10, options);
}

// A worn pad on weak ballast under the first point: both tracks have it.
TEST(TrackReceptance, OverASeatThatDiffersIsThatOfABeam) {
  receptance::ReceptanceOptions options;
  options.highest = 1200;
  options.shapeTolerance = 2e-2;
  options.accuracy = 0.02;
  compareWithBeam(
      cases::loadCase(tests::fixtureCase("smooth-rail"), {"draft",
                                                          {{"track.length", "3"},
                                                           {"track.seats",
                                                            "[{ sleeper = 0, pad_stiffness = 300, pad_damping = 20, "
                                                            "ballast_stiffness = 10, ballast_damping = 20 }]"}}}),
      10, options);
}

// The beam's sleepers have the bending stiffness and mass of each section, and its middle where it lies.
TEST(TrackReceptance, OnSleepersWithALowMiddleIsThatOfABeam) {
  receptance::ReceptanceOptions options;
  options.highest = 1200;
  options.shapeTolerance = 2e-2;
  options.accuracy = 0.02;
  compareWithBeam(cases::loadCase(tests::fixtureCase("smooth-rail"), {"draft",
                                                                      {{"track.length", "3"},
                                                                       {"sleeper.height", "0.2"},
                                                                       {"sleeper.width", "0.22"},
                                                                       {"sleeper.middle_height", "0.13"},
                                                                       {"sleeper.middle_half_length", "0.4"}}}),
                  10, options);
}

// 300 kN/mm up to 15 kN, then 1000 kN/mm: clamped with 50 kN the pad answers by the second slope, unclamped by the
// first. The same system to solve, but for the last digits of the slope.
TEST(TrackReceptance, ProgressivePadAnswersByTheTangentAtItsPreload) {
  receptance::ReceptanceOptions options;
  options.highest = 400;
  options.shapeTolerance = 5e-2;
  options.accuracy = 0.02;
  const std::pair<const char*, const char*> states[] = {{"0", "300"}, {"50", "1000"}};
  for (const auto& [preload, stiffness] : states) {
    const auto curved = solidTrack(
        cases::loadCase(
            tests::fixtureCase("smooth-rail"),
            {"tiny",
             {{"track.length", "3"}, {"pad.curve", "[[0, 0], [0.05, 15], [0.15, 115]]"}, {"pad.preload", preload}}}),
        options);
    const auto linear = solidTrack(cases::loadCase(tests::fixtureCase("smooth-rail"),
                                                   {"tiny", {{"track.length", "3"}, {"pad.stiffness", stiffness}}}),
                                   options);
    for (std::size_t p = 0; p < linear.points.size(); ++p)
      for (std::size_t f = 0; f < linear.frequency.size(); ++f) {
        const auto expected = linear.points[p].receptance[f];
        ASSERT_LT(std::abs(curved.points[p].receptance[f] - expected), 1e-6 * std::abs(expected)) << preload << " kN";
      }
  }
}

}  // namespace
}  // namespace squat::verification
