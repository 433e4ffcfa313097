// Measured passages: event, noise, and what is refused.
#include "estimation/PassageFiles.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <sstream>

#include "core/Errors.h"
#include "readers/TemporaryFile.h"

namespace squat::estimation {
namespace {

using squat::tests::TemporaryFile;
using ::testing::HasSubstr;

// A decaying burst of 800 Hz behind 0.5 m, 100 m/s2, at 30 m/s; white noise of the deviation over all.
std::string record(double length, double noise, const std::string& header = "time [s],position [m],aba [m/s2]",
                   double burst = 100) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, noise);
  std::ostringstream text;
  text.precision(12);
  text << header << "\n";
  const bool position = header.find("position") != std::string::npos;
  for (int i = 0; i < length / 30 * 25000; ++i) {
    const double t = i / 25000.0, x = 30 * t, s = t - 0.5 / 30;
    const double value = s < 0 ? 0 : burst * std::sin(2 * M_PI * 800 * s) * std::exp(-s / 0.001);
    text << t << ",";
    if (position) text << x << ",";
    text << value + normal(random) << "\n";
  }
  return text.str();
}

std::string whyNot(const std::string& text, double cutoff = 2000) {
  const TemporaryFile file(text);
  try {
    readPassages({file.path()}, {}, 30, cutoff);
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

TEST(PassageFiles, FindsEventSpeedAndNoise) {
  const TemporaryFile file(record(1, 2));
  const auto all = readPassages({file.path()}, {}, 25, 2000);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].speed, 30, 0.01);  // of the record; a tenth of a sample
  // White noise low-passed at 2 of 12.5 kHz keeps sqrt(2 / 12.5) of its deviation; 66 independent values tell it to 9
  // %, and the filter that is run forward and back passes a little less than its cut-off says.
  EXPECT_NEAR(all[0].noise, 2 * std::sqrt(2 / 12.5), 0.25);
  EXPECT_NEAR(all[0].impact, 0.5 + 30 * 0.00028, 0.003);  // the first crest of the burst
  EXPECT_GT(all[0].peak, 50);
}

TEST(PassageFiles, TakesTheCasesSpeedWhereTheRecordHasNone) {
  const TemporaryFile file(record(1, 2, "time [s],aba [m/s2]"));
  const auto all = readPassages({file.path()}, {}, 25, 2000);
  EXPECT_NEAR(all[0].speed, 25, 1e-6);
  ASSERT_FALSE(all[0].notes.empty());
  EXPECT_THAT(all[0].notes.back(), HasSubstr("the case's 25 m/s"));
}

TEST(PassageFiles, RefusesWhatCannotBeExplained) {
  EXPECT_THAT(whyNot(record(0.55, 2)), HasSubstr("the record is too short"));
  EXPECT_THAT(whyNot(record(1, 2, "time [s],position [m],aba [m/s2]", 0)),
              ::testing::AnyOf(HasSubstr("no event stands out"), HasSubstr("the record is too short")));
  EXPECT_THAT(whyNot(record(1, 2, "time [s],position [m],aba")), HasSubstr("has no unit"));
  EXPECT_THAT(whyNot(record(1, 2, "time [s],position [m],aba [V]")), HasSubstr("must be an acceleration"));
  EXPECT_THAT(whyNot(record(1, 2), 12000), HasSubstr("sampled at 25000 Hz, too slowly"));
}

}  // namespace
}  // namespace squat::estimation
