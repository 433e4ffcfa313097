// Tracks that others measured or computed: decay rates of the SBB site Niederwangen (CC0), bending modes of its
// sleeper, the reference mobility of the program Rolland (BSD-3). The manual's page "Against measurements" states what
// is seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "case/Resolve.h"
#include "receptance/DecayFiles.h"
#include "receptance/Receptance.h"
#include "verification/Seen.h"

namespace squat::verification {
namespace {

const std::string measurements = SQUAT_SOURCE_DIR "/resources/measurements/";

scenario::Scenario measuredTrack(const std::string& name) {
  return cases::loadScenario(measurements + name + ".toml", {});
}

// 16 vertical and 15 lateral measurements at one site: a computed rate within their range could be one of them. At
// least 16 and 12 of 18 third octaves are wanted; three values of the case are fitted (resources/measurements).
TEST(MeasuredTrack, DecayRatesOfNiederwangen) {
  Monitor quiet;
  const auto rates = receptance::trackDecayRates(measuredTrack("niederwangen"), {}, quiet);
  const auto measured = receptance::readMeasuredDecayRates(measurements + "niederwangen-decay-rates.csv");
  ASSERT_EQ(rates.band.size(), 18u);
  int vertical = 0, lateral = 0;
  for (std::size_t b = 0; b < rates.band.size(); ++b) {
    vertical += measured.at(rates.band[b], receptance::RailDirection::vertical).holds(rates.vertical[b]);
    lateral += measured.at(rates.band[b], receptance::RailDirection::lateral).holds(rates.lateral[b]);
  }
  EXPECT_GE(vertical, 16);
  EXPECT_GE(lateral, 12);
  seen("vertical within what was measured", vertical, "of 18", Worse::smaller);
  seen("lateral within what was measured", lateral, "of 18", Worse::smaller);
}

// Resonances at the rail seat of a B91 sleeper, 450, 700 to 750 (two peaks) and 1150 Hz (RailTrackModellingToolbox,
// HEIG-VD, EPFL and SBB). The case has a block of one width and height: 5 %.
TEST(MeasuredTrack, BendingModesOfTheSleeper) {
  receptance::ReceptanceOptions options;
  options.lowest = 380, options.highest = 1400, options.rails = receptance::StruckRails::one;
  Monitor quiet;
  const auto sleeper = receptance::sleeperByItself(measuredTrack("niederwangen"), options, quiet);
  auto found = receptance::resonances(sleeper.frequency, sleeper.points[0].receptance, 0.5);
  ASSERT_GE(found.size(), 3u);
  const double lowest[] = {450, 700, 1150}, highest[] = {450, 750, 1150};
  for (int mode = 0; mode < 3; ++mode) {
    const double f = found[static_cast<std::size_t>(mode)];
    EXPECT_GT(f, 0.95 * lowest[mode]);
    EXPECT_LT(f, 1.05 * highest[mode]);
    seenDeviation("frequencies of the sleeper", f, std::clamp(f, lowest[mode], highest[mode]));
  }
}

struct Feature {
  double frequency, mobility;  // [Hz], [m/(N s)]
  bool isPeak;
};

// Point mobility over a support, Timoshenko rail on discrete supports, from the file that Rolland ships. 2 % and 1 dB
// are accepted, since the foot of a solid rail bends and its web deforms, which a beam does not.
TEST(MeasuredTrack, MobilityOfRolland) {
  const Feature features[] = {{96, 4.991e-6, true},    {245, 1.679e-6, false}, {501, 1.340e-5, true},
                              {1101, 6.648e-7, false}, {1266, 6.700e-6, true}, {2861, 1.969e-6, false}};
  constexpr int lines = 17;
  constexpr double wide = 0.04;  // to both sides
  std::vector<double> frequency;
  for (const auto& feature : features)
    for (int i = 0; i < lines; ++i) frequency.push_back(feature.frequency * (1 + wide * (2.0 * i / (lines - 1) - 1)));
  receptance::EndlessTrackOptions options;
  options.rails = receptance::StruckRails::both;  // rigid sleepers that only rise and fall, as in the model
  options.wholeSection = true;
  Monitor quiet;
  const auto response =
      receptance::endlessTrackResponse(measuredTrack("rolland"), frequency, {{{0}, {{0}}}}, options, quiet);
  const auto mobility =
      receptance::asQuantity(frequency, response.values[0][0], receptance::ReceptanceQuantity::mobility);
  for (std::size_t f = 0; f < std::size(features); ++f) {
    const auto& feature = features[f];
    const auto first = mobility.begin() + static_cast<long>(f * lines), last = first + lines;
    const auto quieter = [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); };
    const auto at = feature.isPeak ? std::max_element(first, last, quieter) : std::min_element(first, last, quieter);
    ASSERT_NE(at, first);
    ASSERT_NE(at, last - 1);
    const double place = frequency[static_cast<std::size_t>(at - mobility.begin())];
    const double level = std::abs(20 * std::log10(std::abs(*at) / feature.mobility));
    EXPECT_NEAR(place, feature.frequency, 0.02 * feature.frequency);
    EXPECT_LT(level, 1) << feature.frequency << " Hz";
    seenDeviation("frequencies of Rolland", place, feature.frequency);
    seen("levels of Rolland", level, "dB");
  }
}

}  // namespace
}  // namespace squat::verification
