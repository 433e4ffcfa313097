// The endless track, its parts against theory, and decay rates after EN 15461.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "FixtureCase.h"
#include "TemporaryFolder.h"
#include "case/CaseFile.h"
#include "case/DynamicPads.h"
#include "case/Resolve.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "receptance/DecayFiles.h"
#include "receptance/Receptance.h"
#include "receptance/TrackLosses.h"
#include "scenario/ComplexStiffness.h"

namespace squat::receptance {
namespace {

using scenario::padStiffness;
using scenario::viscousEquivalent;
using Complex = std::complex<double>;

scenario::Scenario track(std::vector<std::pair<std::string, std::string>> keys) {
  return cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", std::move(keys)});
}

// A row of equal springs k between equal masses m: with the mass shared between both cells that meet there, the half
// row answers as Z = (k - w^2 m / 2) - k exp(-i q), cos q = 1 - w^2 m / 2 k (textbook dispersion of a lattice). A
// little loss chooses the wave that leaves.
TEST(HalfTracks, RowOfMassesAndSprings) {
  const Complex k(1e8, 1e6);
  const double m = 100, omega = 900;
  Eigen::MatrixXcd cell(2, 2);
  const Complex own = k - omega * omega * m / 2;
  cell << own, -k, -k, own;
  const auto halves = halfTracks(cell);
  const Complex cosine = 1.0 - omega * omega * m / (2.0 * k);
  Complex wave = cosine + std::sqrt(cosine * cosine - 1.0);
  if (std::abs(wave) > 1) wave = 1.0 / wave;
  const Complex expected = own - k * wave;
  EXPECT_LT(std::abs(halves.behind(0, 0) - expected), 1e-8 * std::abs(expected));
  EXPECT_LT(std::abs(halves.before(0, 0) - expected), 1e-8 * std::abs(expected));
}

// Betti: what a place answers to another, that answers to it. Across bays, sideways too, with one rail struck.
TEST(EndlessTrack, IsReciprocal) {
  const auto scenario = track({{"pad.loss_factor", "0.2"}, {"ballast.loss_factor", "0.5"}});
  const RailPlace here{0.1, RailDirection::vertical}, there{1.45, RailDirection::lateral};
  EndlessTrackOptions options;
  options.stationLength = 0.05, options.shapeTolerance = 5e-2, options.sleeperIntervals = 8;
  Monitor quiet;
  const auto response = endlessTrackResponse(scenario, {300, 900}, {{here, {there}}, {there, {here}}}, options, quiet);
  for (std::size_t f = 0; f < 2; ++f) {
    const auto to = response.values[0][0][f], back = response.values[1][0][f];
    EXPECT_GT(std::abs(to), 0);
    EXPECT_LT(std::abs(to - back), 1e-6 * std::abs(to));
  }
}

// Far from its ends a finite track that damps its waves is an endless one. 12 m with absorbing ends; what is left are
// the ends and the other stations (20 mm near the middle, 50 mm elsewhere): 3 % of the receptance.
TEST(EndlessTrack, IsTheMiddleOfALongOne) {
  const auto scenario = track({{"track.length", "12"},
                               {"track.rail_ends", "absorbing"},
                               {"pad.loss_factor", "0.3"},
                               {"rail.loss_factor", "0.05"},
                               {"sleeper.loss_factor", "0.2"},
                               {"ballast.loss_factor", "1"}});
  ReceptanceOptions options;
  options.lowest = 200, options.highest = 700, options.wheelset = false;
  options.shapeTolerance = 2e-2, options.frequencyStep = 50;
  Monitor quiet;
  const auto whole = trackReceptance(scenario, options, quiet);
  EndlessTrackOptions endless;
  endless.rails = StruckRails::both, endless.wholeSection = true, endless.shapeTolerance = 2e-2;
  endless.sleeperIntervals = 32;  // as there
  const auto response =
      endlessTrackResponse(scenario, whole.frequency, {{{0}, {{0}}}, {{-0.3}, {{-0.3}}}}, endless, quiet);
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t f = 0; f < whole.frequency.size(); ++f) {
      const auto expected = whole.points[p].receptance[f];
      EXPECT_LT(std::abs(response.values[p][0][f] - expected), 0.03 * std::abs(expected))
          << whole.points[p].name << ", " << whole.frequency[f] << " Hz";
    }
}

TEST(EndlessTrack, RefusesSeatsThatDiffer) {
  const auto scenario = track({{"track.seats", "[{ sleeper = 0, pad_stiffness = 300 }]"}});
  Monitor quiet;
  EXPECT_THROW(endlessTrackResponse(scenario, {300}, {{{0}, {{0}}}}, {}, quiet), CaseError);
}

// A response exp(-b x) decays by 8.686 b dB/m (EN 15461, A.1). The sum takes the place of an integral: 3 % where a bay
// is short against 1 / b.
TEST(DecayRate, OfAnExponentialIsItsOwn) {
  constexpr double bay = 0.6, b = 0.2;
  std::vector<double> squares;
  for (const double bays : decayPositions()) squares.push_back(std::exp(-2 * b * bays * bay));
  EXPECT_EQ(squares.size(), 29u);  // EN 15461, 6.7
  EXPECT_NEAR(decayRate(squares, bay), 8.686 * b, 0.03 * 8.686 * b);
}

// ISO 3095:2013, Figure 3, a few of its printed numbers.
TEST(DecayRate, LimitsAreThoseOfTheStandard) {
  EXPECT_EQ(decayLimit(500, RailDirection::vertical), 6);
  EXPECT_EQ(decayLimit(800, RailDirection::vertical), 2.19);
  EXPECT_EQ(decayLimit(250, RailDirection::lateral), 2.04);
  EXPECT_EQ(decayLimit(1600, RailDirection::lateral), 0.32);
  EXPECT_TRUE(std::isnan(decayLimit(100, RailDirection::vertical)));
}

// A spring and a dashpot are their own equivalent; a loss factor of 0.2 has none that is near at all frequencies.
TEST(ViscousEquivalent, OfASpringAndADashpotIsThese) {
  const auto viscous = [](double f) { return Complex(3e8, 2 * std::numbers::pi * f * 4e4); };
  const auto own = viscousEquivalent(viscous, 100, 2000);
  EXPECT_NEAR(own.stiffness, 3e8, 1);
  EXPECT_NEAR(own.damping, 4e4, 1e-3);
  EXPECT_LT(own.misfit, 1e-9);
  const auto lossy = viscousEquivalent([](double) { return Complex(3e8, 6e7); }, 100, 2000);
  EXPECT_NEAR(lossy.stiffness, 3e8, 1);
  EXPECT_GT(lossy.misfit, 0.05);
}

class DecayFile : public testing::Test {
 protected:
  std::string written(const std::string& text) {
    const auto path = folder_ / "table.csv";
    writeDurably(path, std::string_view(text));
    return path;
  }

 private:
  tests::TemporaryFolder folder_;
};

TEST_F(DecayFile, RowsOfMeasurements) {
  const auto measured = readMeasuredDecayRates(
      written("no;direction;100 Hz [dB/m];125 Hz [dB/m]\n1;v;3,0;4\n2;h;9;nan\n3;vertical;5,0;6\n"));
  const auto at = measured.at(100, RailDirection::vertical);
  EXPECT_EQ(at.count, 2);
  EXPECT_EQ(at.lowest, 3);
  EXPECT_EQ(at.mean, 4);
  EXPECT_EQ(at.highest, 5);
  EXPECT_EQ(measured.at(125, RailDirection::lateral).count, 0);
}

TEST_F(DecayFile, OneRowAThirdOctave) {
  const auto measured =
      readMeasuredDecayRates(written("frequency [Hz], vertical [dB/m], lateral [dB/m]\n100, 3, 9\n125, 4, 8\n"));
  EXPECT_EQ(measured.at(125, RailDirection::lateral).mean, 8);
}

TEST_F(DecayFile, AsksForTheUnitAndTheDirection) {
  EXPECT_THROW(readMeasuredDecayRates(written("direction,100 Hz\nv,3\n")), FileError);
  EXPECT_THROW(readMeasuredDecayRates(written("direction,100 Hz [dB/m]\nx,3\n")), FileError);
  EXPECT_THROW(readMeasuredDecayRates(written("a,b\n1,2\n")), FileError);
}

// Between the rows linear in the logarithm of the frequency; 200 is half-way from 100 to 400.
TEST_F(DecayFile, DynamicPads) {
  const auto table = cases::readDynamicStiffness(
      written("frequency [Hz], stiffness real [MN/m], stiffness imaginary [MN/m]\n100, 300, 30\n400, 500, 70\n"));
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[1].vertical, Complex(500e6, 70e6));
  scenario::Pad pad;
  pad.stiffness = 1, pad.dynamic = table;
  EXPECT_LT(std::abs(padStiffness(pad, 200) - Complex(400e6, 50e6)), 1);
  EXPECT_EQ(padStiffness(pad, 50), table.front().vertical);
}

// A published file gives N/mm for what can only be N/m: 3.9e12 N/m is no pad.
TEST_F(DecayFile, DynamicPadsOfAnImpossibleStiffness) {
  EXPECT_THROW(
      cases::readDynamicStiffness(written("FREQ [Hz],vertical stiffness Real [N/mm],vertical stiffness Imaginary "
                                          "[N/mm]\n200,3862823784,608114861\n")),
      FileError);
  EXPECT_THROW(cases::readDynamicStiffness(written("f [Hz],real,imaginary\n200,300,30\n")), FileError);
}

}  // namespace
}  // namespace squat::receptance
