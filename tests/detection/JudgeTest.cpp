// Bayes' rule over a handful of examples whose answer can be said beforehand.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/Errors.h"
#include "detection/Examples.h"

namespace squat::detection {
namespace {

using ::testing::HasSubstr;

Example example(Kind kind, const std::string& vehicle, double energy, double length = 0, double depth = 0) {
  Example made;
  made.kind = kind, made.vehicle = vehicle, made.length = length, made.depth = depth, made.speed = 30;
  // Long waves for the weld, all waves for the others.
  for (std::size_t b = 0; b < bandCount; ++b)
    made.energy[b] = kind == Kind::weld ? energy * std::pow(0.1, static_cast<double>(b)) : energy;
  return made;
}

EventFeatures eventLike(const Example& cause, double speed = 30, double noise = 0.01) {
  EventFeatures event;
  event.speed = speed;
  for (std::size_t b = 0; b < bandCount; ++b) {
    event.freedom[b] = 20;
    event.noise[b] = noise;
    event.energy[b] = noise + cause.energy[b] * speed * speed / (cause.speed * cause.speed);
  }
  return event;
}

// Examples that lie close together: each stands for its own size alone.
JudgementOptions close() {
  JudgementOptions options;
  options.commonSpread = 0.05, options.sizeSpread = 0.05;
  return options;
}

std::vector<Example> known() {
  return {example(Kind::squat, "a", 1, 0.02, 0.05e-3), example(Kind::squat, "a", 30, 0.05, 0.2e-3),
          example(Kind::squat, "a", 1000, 0.08, 0.4e-3), example(Kind::weld, "a", 30)};
}

TEST(Judge, TakesAnEventForWhatItsLikeWas) {
  const Judge judge(known(), close());
  const auto judged =
      judge.judge({eventLike(known()[0]), eventLike(known()[1]), eventLike(known()[2]), eventLike(known()[3])});
  EXPECT_EQ(judged[0].severity, Severity::light);
  EXPECT_EQ(judged[1].severity, Severity::moderate);
  EXPECT_EQ(judged[2].severity, Severity::severe);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(judged[static_cast<std::size_t>(i)].kind, Kind::squat);
  EXPECT_EQ(judged[3].kind, Kind::weld);
  EXPECT_DOUBLE_EQ(judged[1].length, 0.05);
  EXPECT_DOUBLE_EQ(judged[1].depth, 0.2e-3);
}

// Energies go with the square of the speed: the same defect at 33 m/s is still the same.
TEST(Judge, CountsAnExampleAtTheSpeedOfTheEvent) {
  const Judge judge(known(), close());
  EXPECT_EQ(judge.judge({eventLike(known()[1], 33)}).front().severity, Severity::moderate);
}

TEST(Judge, NoiseIsNothing) {
  const Judge judge(known(), close());
  auto noise = eventLike(known()[0], 30, 1.0);
  noise.energy = noise.noise;
  EXPECT_GT(judge.judge({noise}).front().nothing, 0.9);
  EXPECT_LT(judge.judge({eventLike(known()[1])}).front().nothing, 1e-6);
}

// One vehicle's squats are ten times as loud as another's: an event between says little, but beside events that only
// the loud vehicle explains, it is the lighter squat.
TEST(Judge, EventsOfOneRecordShareTheirVehicle) {
  std::vector<Example> two{
      example(Kind::squat, "loud", 10, 0.03, 0.08e-3),  example(Kind::squat, "loud", 100, 0.05, 0.2e-3),
      example(Kind::squat, "loud", 1000, 0.08, 0.4e-3), example(Kind::squat, "still", 1, 0.03, 0.08e-3),
      example(Kind::squat, "still", 10, 0.05, 0.2e-3),  example(Kind::squat, "still", 100, 0.08, 0.4e-3)};
  const Judge judge(two, close());
  const auto between = eventLike(two[1]);
  const auto alone = judge.judge({between}).front();
  EXPECT_NEAR(alone.severitySureness, 0.5, 0.05) << "moderate on one vehicle, severe on the other";
  std::vector<EventFeatures> record(6, eventLike(two[2]));
  record.push_back(between);
  const auto together = judge.judge(record).back();
  EXPECT_EQ(together.severity, Severity::moderate);
  EXPECT_GT(together.severitySureness, 0.9);
}

TEST(Examples, AreReadAsTheyWereWritten) {
  const auto path = (std::filesystem::temp_directory_path() / "examples-test.csv").string();
  auto some = known();
  some[1].offset = -0.012, some[1].weight = 2.5, some[1].before = 0.25, some[1].reach = 0.75;
  std::ofstream(path) << examplesText(some);
  const auto read = readExamples(path);
  ASSERT_EQ(read.size(), some.size());
  EXPECT_EQ(read[1].energy, some[1].energy);
  EXPECT_NEAR(read[1].offset, -0.012, 1e-15);
  EXPECT_DOUBLE_EQ(read[1].weight, 2.5);
  EXPECT_EQ(examplesText(read), examplesText(some));
  std::ofstream(path) << "kind\nsquat\n";
  try {
    readExamples(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 2"));
  }
  std::filesystem::remove(path);
}

TEST(Severity, GoesByTheWorseOfLengthAndDepth) {
  EXPECT_EQ(severityOf(0.035, 0.10e-3), Severity::light);
  EXPECT_EQ(severityOf(0.036, 0.05e-3), Severity::moderate);
  EXPECT_EQ(severityOf(0.020, 0.11e-3), Severity::moderate);
  EXPECT_EQ(severityOf(0.060, 0.25e-3), Severity::moderate);
  EXPECT_EQ(severityOf(0.061, 0.05e-3), Severity::severe);
  EXPECT_EQ(severityOf(0.030, 0.26e-3), Severity::severe);
}

// A railway that grinds earlier: what is moderate by convention is severe there.
TEST(Severity, LimitsAreTheUsers) {
  const auto limits = severityLimitsFromText("20x0.05", "40x0.1");
  EXPECT_EQ(severityOf(0.020, 0.05e-3, limits), Severity::light);
  EXPECT_EQ(severityOf(0.035, 0.10e-3, limits), Severity::moderate);
  EXPECT_EQ(severityOf(0.060, 0.25e-3, limits), Severity::severe);
  EXPECT_EQ(severityLimitsFromText("", "").lightLength, 0.035) << "by convention";
  EXPECT_EQ(severityLimitsFromText("", "80x0.3").lightDepth, 0.10e-3);
  for (const char* text : {"35", "35x", "x0.1", "35x0", "-1x0.1", "35 mm x 0.1 mm", "35x0.1x2"})
    EXPECT_THROW(severityLimitsFromText(text, ""), CaseError) << text;
  EXPECT_THROW(severityLimitsFromText("70x0.1", ""), CaseError) << "longer than what is moderate";
}

}  // namespace
}  // namespace squat::detection
