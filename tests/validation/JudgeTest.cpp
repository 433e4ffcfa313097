#include "validation/Judge.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "validation/Measures.h"

namespace squat::validation {
namespace {

using ::testing::HasSubstr;

// A decaying wave of the given frequency after the impact at x = 0, on a quiet record.
results::RunResult made(double frequency, double height = 80, double speed = 30) {
  results::RunResult result;
  result.speed = speed;
  results::Channel aba{"aba_filtered", "m/s2", "", {}};
  for (int i = 0; i < 1500; ++i) {
    const double time = i / 25000.0, after = time - 0.02;
    result.time.push_back(time);
    result.position.push_back(speed * after);
    const double wave = height * std::exp(-after / 0.004) * std::cos(2 * std::numbers::pi * frequency * after);
    aba.values.push_back(after < -1e-9 ? 0.001 * std::sin(i) : wave);
  }
  result.signals.push_back(aba);
  return result;
}

Statement statement(const std::string& name, double low, double high) {
  Statement s;
  s.run = "a";
  s.measure = name;
  s.low = low;
  s.high = high;
  return s;
}

Judged judgedOf(const Statement& s, const std::map<std::string, results::RunResult>& results) {
  return judge({"", {}, {s}}, results, "draft").at(0);
}

TEST(Measures, OfAWaveOfKnownFrequency) {
  const auto result = made(1000);
  EXPECT_EQ(measure(result, statement("maximum", 0, 1)), 80);
  // 30 m/s over 1000 Hz: 30 mm; the ridge of a decaying wave wanders by a few per cent.
  EXPECT_NEAR(measure(result, statement("wavelength", 0, 1)).value(), 30, 1.5);
  EXPECT_NEAR(measure(result, statement("wave_frequency", 0, 1)).value(), 1000, 50);
  auto line = statement("line", 0, 1);
  line.near = 1034;
  EXPECT_NEAR(measure(result, line).value(), 1000, 10);  // the resolution of 0.38 m at 30 m/s is 79 Hz
  auto share = statement("band_share", 0, 1);
  share.band = {800, 1200};
  // A Lorentz line of half width 1/(2 pi 4 ms) = 40 Hz has (2/pi) atan(200/40) = 0.87 of its power within 200 Hz; the
  // taper softens the step at the impact, which makes the wings: more than that, less than all.
  EXPECT_GT(measure(result, share).value(), 0.87);
  EXPECT_LT(measure(result, share).value(), 0.99);
  EXPECT_LT(measure(result, statement("quiet", 0, 1)).value(), 0.01);
}

TEST(Judge, WithinTheRangeIsMetOutsideIsNot) {
  const std::map<std::string, results::RunResult> results{{"a", made(1000)}};
  EXPECT_EQ(judgedOf(statement("maximum", 70, 90), results).verdict, Verdict::met);
  EXPECT_EQ(judgedOf(statement("maximum", 90, 110), results).verdict, Verdict::notMet);
  EXPECT_EQ(judgedOf(statement("maximum", 80, 81), results).verdict, Verdict::met) << "the bounds belong to the range";
}

TEST(Judge, RatiosOfTwoRuns) {
  const std::map<std::string, results::RunResult> results{{"a", made(1000, 60)}, {"b", made(1000, 80)}};
  auto ratio = statement("maximum", 0.7, 0.8);
  ratio.against = "b";
  const auto judged = judgedOf(ratio, results);
  EXPECT_DOUBLE_EQ(judged.value.value(), 0.75);
  EXPECT_EQ(judged.verdict, Verdict::met);
}

TEST(Judge, WhatCannotBeJudgedSaysWhy) {
  EXPECT_EQ(judgedOf(statement("maximum", 0, 1), {}).verdict, Verdict::notJudged);
  EXPECT_THAT(judgedOf(statement("maximum", 0, 1), {}).why, HasSubstr("run a has no result"));
  EXPECT_THAT(judgedOf(statement("maximum", 0, 1), {{"a", {}}}).why, HasSubstr("does not have it"));
  EXPECT_THAT(judgedOf(statement("wavelength", 0, 1), {{"a", {}}}).why, HasSubstr("does not have it"));
  auto paperOnly = statement("elements", 0, 1);
  paperOnly.mesh = "paper";
  EXPECT_THAT(judgedOf(paperOnly, {{"a", {}}}).why, HasSubstr("--mesh paper"));
}

TEST(Judge, TheTableHoldsEveryStatement) {
  auto none = statement("none", 0, 0);
  none.text = "one, with a comma";
  none.reason = "not published";
  const auto csv = judgedCsv(judge({"", {}, {none, statement("maximum", 70, 90)}}, {{"a", made(1000)}}, "draft"));
  EXPECT_EQ(csv,
            "section,statement,run,against,value,low,high,unit,verdict,reason\n"
            ",\"one, with a comma\",a,,,,,,not judged,not published\n,,a,,80,70,90,,met,\n");
}

}  // namespace
}  // namespace squat::validation
