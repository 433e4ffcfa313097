// Losses in the frequency domain, and sleepers that do not move.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

#include "TemporaryFolder.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "keys/Keys.h"
#include "receptance/DecayRate.h"
#include "receptance/TrackLosses.h"

namespace squat {
namespace {

using receptance::TrackPart;

std::complex<double> factorOf(const scenario::Scenario& scenario, TrackPart part) {
  const auto losses = receptance::trackLosses(scenario);
  return losses[static_cast<std::size_t>(part)](2 * std::numbers::pi * 500);
}

TEST(LossKeys, MakeStiffnessComplex) {
  const auto scenario = tests::scenarioWith({{"rail.loss_factor", "0.01"},
                                             {"sleeper.loss_factor", "0.03"},
                                             {"pad.loss_factor", "0.2"},
                                             {"ballast.loss_factor", "0.9"}});
  EXPECT_EQ(factorOf(scenario, TrackPart::rail), std::complex<double>(1, 0.01));
  EXPECT_EQ(factorOf(scenario, TrackPart::sleepers), std::complex<double>(1, 0.03));
  EXPECT_EQ(factorOf(scenario, TrackPart::padsVertical), std::complex<double>(1, 0.2));
  EXPECT_EQ(factorOf(scenario, TrackPart::padsHorizontal), std::complex<double>(1, 0.2));
  EXPECT_EQ(factorOf(scenario, TrackPart::ballast), std::complex<double>(1, 0.9));
}

// The table's stiffness, whatever the case states; sideways the case's, with the table's loss factor of 0.1.
TEST(LossKeys, DynamicPadsTakeThePlaceOfTheStiffness) {
  const tests::TemporaryFolder folder;
  const auto path = folder / "pads.csv";
  writeDurably(path, std::string_view("frequency [Hz], stiffness real [MN/m], stiffness imag [MN/m]\n"
                                      "100, 400, 40\n1000, 400, 40\n"));
  const auto scenario = tests::scenarioWith({{"pad.dynamic", path}, {"pad.stiffness", "200"}});
  EXPECT_LT(std::abs(factorOf(scenario, TrackPart::padsVertical) - std::complex<double>(2, 0.2)), 1e-12);
  EXPECT_LT(std::abs(factorOf(scenario, TrackPart::padsHorizontal) - std::complex<double>(1, 0.1)), 1e-12);
}

// A table with lateral values, 100 + 5 i for a case of 50 MN/m: twice, and a loss factor of 0.05.
TEST(LossKeys, DynamicValuesAreTheTable) {
  const auto scenario = tests::scenarioWith({{"pad.dynamic_values", "100: 400 40 100 5, 1000: 400 40 100 5"},
                                             {"pad.stiffness", "200"},
                                             {"pad.lateral_stiffness", "50"}});
  EXPECT_LT(std::abs(factorOf(scenario, TrackPart::padsVertical) - std::complex<double>(2, 0.2)), 1e-12);
  EXPECT_LT(std::abs(factorOf(scenario, TrackPart::padsHorizontal) - std::complex<double>(2, 0.1)), 1e-12);
  EXPECT_THROW(tests::scenarioWith({{"pad.dynamic_values", "100: 400 40, 50: 400 40"}}), CaseError);
  EXPECT_THROW(tests::scenarioWith({{"pad.dynamic_values", "100: 400"}}), CaseError);
  EXPECT_THROW(tests::scenarioWith({{"pad.dynamic_values", " "}}), CaseError);
}

// Every unknown of a fixed sleeper is fixed.
TEST(SleeperKeys, FixedSleepersDoNotMove) {
  const auto model = tests::modelWith({{"sleeper.fixed", "true"}});
  const std::set<std::size_t> fixed(model.fixed.begin(), model.fixed.end());
  const auto& sleeper = model.blocks[model.firstSleeper];
  for (int n = 0; n < sleeper.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      for (int s = 0; s < sleeper.stationCount; ++s) ASSERT_EQ(fixed.count(sleeper.index(n, c, s)), 1U);
}

// A rail on pads on the ground is a beam on an elastic foundation: K = 2 sqrt(2) (E I)^(1/4) u^(3/4) with u the pads'
// stiffness per metre (Winkler, Zimmermann). EI of 54E1: 210 GPa, 2338 cm4 (EN 13674-1). 8 %: shear, which grows with
// u / (G A kappa) beside 2 sqrt(u / 4 E I), here 7 % of it, half of that in the deflection; the foot in series with
// soft pads 1 %, inertia at 10 Hz below 1 %; the rest for the pads' distance.
TEST(SleeperKeys, FixedSleepersLeaveABeamOnPads) {
  const auto scenario = tests::scenarioWith({{"sleeper.fixed", "true"}, {"pad.stiffness", "30"}});
  receptance::EndlessTrackOptions options;
  options.rails = receptance::StruckRails::both, options.wholeSection = true;
  options.stationLength = 0.04, options.shapeTolerance = 2e-2, options.sleeperIntervals = 8;
  Monitor quiet;
  const auto found = receptance::endlessTrackResponse(scenario, {10}, {{{0}, {{0}}}, {{0.3}, {{0.3}}}}, options, quiet);
  const double mean = 0.5 * (std::abs(found.values[0][0][0]) + std::abs(found.values[1][0][0]));
  const double beam = 2 * std::sqrt(2.0) * std::pow(210e9 * 2338e-8, 0.25) * std::pow(30e6 / 0.6, 0.75);
  EXPECT_NEAR(mean, 1 / beam, 0.08 / beam);
}

}  // namespace
}  // namespace squat
