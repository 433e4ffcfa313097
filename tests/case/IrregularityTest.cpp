// Irregular rails: levels, heights and their files.
#include "scenario/Irregularity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/LevelsText.h"
#include "case/Resolve.h"
#include "case/Validation.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;

const std::vector<WavelengthLevel> kLevels{{0.01, -8.0}, {0.02, -6.2}, {0.04, -3.2}};

Irregularity askedLevels(double seed = 7) {
  Irregularity options;
  options.kind = IrregularityKind::spectrum;
  options.seed = seed, options.shortest = 0.01, options.longest = 0.04;
  return options;
}

// Heights and first harmonic of an own computation in Python 3.11 of what Irregularity.h says, with the generator
// written out (Matsumoto and Nishimura, mt19937-64; its 10000th output for seed 5489 is 9981545732273789042).
// Cosines and powers of two libraries differ in the last digits: 1e-12 of some micrometres.
TEST(Irregularity, IsTheSumThatItsHeaderSays) {
  const auto surface = IrregularSurface::ofSpectrum(kLevels, askedLevels(), -0.3);
  ASSERT_EQ(surface.harmonics().size(), 7u * 64);
  EXPECT_NEAR(surface.harmonics().front().wavenumber, 560.703283509824, 1e-9);
  EXPECT_NEAR(surface.harmonics().front().amplitude, 7.219187249034692e-08, 1e-19);
  EXPECT_NEAR(surface.harmonics().front().phase, 4.34250693458366, 1e-13);
  EXPECT_NEAR(surface.harmonics().back().wavenumber, 176.97961462205285, 1e-9);
  EXPECT_NEAR(surface.harmonics().back().phase, 3.5009312765297826, 1e-13);
  const std::pair<double, double> expected[] = {{-0.291, 0},
                                                {-0.27, 4.711880595852202e-07},
                                                {-0.1, -2.712616930536045e-06},
                                                {0, -6.402924515252869e-07},
                                                {0.123, -5.036708611997704e-07}};
  for (const auto& [x, height] : expected) EXPECT_NEAR(surface.height(x), height, 1e-17) << x;
}

// The mean square of harmonics over a long way is the sum of A^2 / 2, exactly; here of each third octave. The levels of
// 12.6, 15.8, 25.1 and 31.6 mm lie on the straight lines between those of the table, nearly: thirds of the way in the
// logarithm, from the table's nominal wavelengths.
TEST(Irregularity, EveryThirdOctaveHasItsLevel) {
  auto options = askedLevels();
  options.offset = 12;
  const auto surface = IrregularSurface::ofSpectrum(kLevels, options, -0.3);
  const double expected[] = {-8, -7.4, -6.8, -6.2, -5.2, -4.2, -3.2};
  for (int band = 0; band < 7; ++band) {
    double power = 0;
    for (int i = 0; i < 64; ++i) {
      const auto& h = surface.harmonics()[static_cast<std::size_t>(64 * band + i)];
      power += 0.5 * h.amplitude * h.amplitude;
      const double middle = std::pow(10.0, (band - 20) / 10.0), wavelength = 2 * M_PI / h.wavenumber;
      EXPECT_LE(std::abs(10 * std::log10(wavelength / middle)), 0.5 + 1e-12);
    }
    EXPECT_NEAR(10 * std::log10(power / 1e-12), expected[band] + 12, band % 3 ? 0.02 : 1e-9) << band;
  }
}

// Laid heights themselves, over 400 m: the mean square of 448 harmonics comes out to some tenths of a per cent there.
TEST(Irregularity, HeightsHaveThePowerOfTheirHarmonics) {
  const auto surface = IrregularSurface::ofSpectrum(kLevels, askedLevels(), -1);
  double expected = 0, mean = 0, square = 0;
  for (const auto& h : surface.harmonics()) expected += 0.5 * h.amplitude * h.amplitude;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double height = surface.height(0.00401 * i);
    mean += height / count, square += height * height / count;
  }
  EXPECT_NEAR((square - mean * mean) / expected, 1, 0.01);
}

TEST(Irregularity, OtherLimitsLeaveTheWavesBetweenThem) {
  auto shorter = askedLevels();
  shorter.longest = 0.02;
  const auto all = IrregularSurface::ofSpectrum(kLevels, askedLevels(), 0),
             some = IrregularSurface::ofSpectrum(kLevels, shorter, 0);
  ASSERT_EQ(some.harmonics().size(), 4u * 64);
  for (std::size_t i = 0; i < some.harmonics().size(); ++i)
    EXPECT_EQ(some.harmonics()[i].phase, all.harmonics()[i].phase);
  EXPECT_NE(IrregularSurface::ofSpectrum(kLevels, askedLevels(8), 0).harmonics()[0].phase, all.harmonics()[0].phase);
}

TEST(Irregularity, StartsLevelAtZero) {
  const auto surface = IrregularSurface::ofSpectrum(kLevels, askedLevels(), -0.2);
  for (double x = -0.25; x <= -0.19; x += 0.001) EXPECT_EQ(surface.height(x), 0);
  EXPECT_NE(surface.height(-0.15), 0);
}

TEST(Irregularity, GoesThroughItsHeights) {
  Irregularity options;
  options.kind = IrregularityKind::heights;
  options.points = {{100, 1e-5}, {100.1, 2e-5}, {100.2, -3e-5}, {100.5, 0}};
  options.position = 100.1, options.offset = 20 * std::log10(2.0);
  const auto surface = IrregularSurface::ofHeights(options, -0.1);  // starts on the first point
  // Positions of 100 m are known to 1.4e-14 m: times a slope of 1e-3.
  EXPECT_NEAR(surface.height(0), 2e-5, 1e-16);  // 2 (20 um - 10 um)
  EXPECT_NEAR(surface.height(0.1), -8e-5, 1e-16);
  EXPECT_GE(surface.steepest(), 2 * 5e-5 / 0.1);
}

// The three values of ISO 3095:2013 that its users quote most.
TEST(Irregularity, KnowsTheLimitOfIso3095) {
  const auto& limit = scenario::iso3095Limit();
  EXPECT_EQ(scenario::levelAt(limit, 0.04), -3.2);
  EXPECT_EQ(scenario::levelAt(limit, 0.02), -6.2);
  EXPECT_EQ(scenario::levelAt(limit, 0.01), -8.0);
  EXPECT_EQ(scenario::levelAt(limit, 0.0063), scenario::levelAt(limit, 0.006309573)) << "nominal and exact";
  EXPECT_EQ(scenario::levelAt(limit, 0.5), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(scenario::thirdOctaveWavelengths(0.00315, 0.4).size(), limit.size());
  EXPECT_EQ(levelsMistake(limit), "");
}

TEST(LevelsText, ReadsWhatItWrites) {
  const auto levels = parseLevels(" 10: -8, 20 :-6.2,40:-3.2 ");
  ASSERT_TRUE(levels);
  EXPECT_EQ(formatLevels(*levels), "10: -8, 20: -6.2, 40: -3.2");
  EXPECT_EQ((*levels)[1].wavelength, 0.02);
  EXPECT_TRUE(parseLevels("")->empty());
  for (const char* wrong : {"10", "10: x", "10: -8,", "10: -8: 3", "; 10: -8"})
    EXPECT_FALSE(parseLevels(wrong)) << wrong;
}

TEST(LevelsTable, OneThirdOctaveARow) {
  for (const char* text : {"wavelength [cm],level [dB re 1 um]\n1,-8\n4,-3.2\n2,-6.2\n",
                           "level [dB];wavelength [mm]\n-8;10\n-6.2;20\n-3.2;40\n"}) {
    const auto levels = parseLevelsTable(text, "s.csv");
    ASSERT_EQ(levels.size(), 3u) << text;
    EXPECT_NEAR(levels[0].wavelength, 0.01, 1e-15);
    EXPECT_EQ(levels[1].level, -6.2);
    EXPECT_EQ(levels[2].level, -3.2);
  }
}

// Columns named by their wavelengths, a measurement a row: mean squares of 0 and 10 dB are 1 and 10 um2.
TEST(LevelsTable, OneMeasurementARow) {
  const auto levels =
      parseLevelsTable("site,rail,1 cm [dB re 1 um],1.2589 cm [dB re 1 um]\nB2,L,0,nan\nB2,R,10,3\n", "s.csv");
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_NEAR(levels[0].level, 10 * std::log10(5.5), 1e-12);
  EXPECT_NEAR(levels[1].wavelength, 0.012589, 1e-15);
  EXPECT_NEAR(levels[1].level, 3, 1e-12);
}

TEST(LevelsTable, RefusesWhatIsNone) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      parseLevelsTable(text, "s.csv");
    } catch (const FileError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(refusal("position [mm],height [um]\n1,2\n2,3\n"), HasSubstr("no column of levels in dB"));
  EXPECT_THAT(refusal("frequency [Hz],level [dB]\n1,2\n2,3\n"), HasSubstr("no column of wavelengths"));
  EXPECT_THAT(refusal("wavelength [mm],level [dB]\n10,2\n10,3\n"), HasSubstr("appear twice"));
}

CaseDescription roughCase(const std::vector<std::pair<std::string, std::string>>& values) {
  return loadCase(tests::fixtureCase("smooth-rail"), {"draft", values});
}

std::string warningsOfRough(const CaseDescription& description) {
  std::string all;
  for (const auto& warning : validate(description).warnings) all += toText(warning) + "\n";
  return all;
}

TEST(IrregularityOfACase, SaysWhatTheMeshCannotShow) {
  const auto coarse = warningsOfRough(roughCase({{"rail.irregularity", "iso-3095"}}));
  EXPECT_THAT(coarse, HasSubstr("rail.irregularity_shortest"));
  EXPECT_THAT(coarse, HasSubstr("2 elements a wave"));
  EXPECT_THAT(warningsOfRough(roughCase(
                  {{"rail.irregularity", "iso-3095"}, {"mesh.rolling_size", "2.5"}, {"mesh.contact_size", "2.5"}})),
              testing::Not(HasSubstr("elements a wave")));
  EXPECT_THAT(warningsOfRough(roughCase({{"rail.irregularity", "iso-3095"}, {"rail.irregularity_longest", "1000"}})),
              HasSubstr("The spectrum ends there"));
}

TEST(IrregularityOfACase, RefusesWhatCannotBe) {
  const auto refusal = [](const std::vector<std::pair<std::string, std::string>>& values) -> std::string {
    try {
      roughCase(values);
    } catch (const CaseError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(refusal({{"rail.irregularity", "spectrum"}}), HasSubstr("at least one level"));
  EXPECT_THAT(refusal({{"rail.irregularity", "spectrum"}, {"rail.irregularity_levels", "1"}}),
              HasSubstr("pairs of wavelength and level"));
  EXPECT_THAT(refusal({{"rail.irregularity", "heights"}}), HasSubstr("at least two points"));
  EXPECT_THAT(refusal({{"rail.irregularity", "heights"}, {"rail.irregularity_points", "[[5000, 0], [6000, 0.1]]"}}),
              HasSubstr("such that the heights lie where the wheel rolls"));
  EXPECT_THAT(refusal({{"rail.irregularity", "iso-3095"},
                       {"rail.irregularity_shortest", "100"},
                       {"rail.irregularity_longest", "50"}}),
              HasSubstr("a third octave between them"));
}

// A written case holds the numbers: it needs no file, and what was computed before there were such keys keeps its hash.
TEST(IrregularityOfACase, IsKeptInTheWrittenCase) {
  const auto rough = roughCase({{"rail.irregularity", "spectrum"}, {"rail.irregularity_levels", "20: -6.2, 40: -3.2"}});
  const auto again = parseCase(writeCase(rough), "x.toml");
  const auto one = resolve(rough).irregularity, other = resolve(again).irregularity;
  for (const double x : {-0.2, 0.0, 0.1}) EXPECT_EQ(one.height(x), other.height(x));
  EXPECT_EQ(caseHash(rough), caseHash(again));
  const auto smooth = roughCase({});
  EXPECT_NE(caseHash(rough), caseHash(smooth));
  EXPECT_EQ(caseHash(smooth), caseHash(roughCase({{"rail.irregularity_seed", "5"}})));
  EXPECT_TRUE(resolve(smooth).irregularity.isSmooth());
}

}  // namespace
}  // namespace squat::cases
