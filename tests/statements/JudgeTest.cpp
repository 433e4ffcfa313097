#include "case/CaseDescription.h"
#include "statements/Judge.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "signals/BandDecay.h"
#include "statements/Measures.h"

namespace squat::statements {
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

Reference referenceOf(const std::vector<Statement>& statements) {
  Reference reference;
  reference.statements = statements;
  return reference;
}

Judged judgedOf(const Statement& s, const std::map<std::string, results::RunResult>& results) {
  return judge(referenceOf({s}), results, "draft").at(0);
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
  EXPECT_LT(measure(result, statement("residual_vibration", 0, 1)).value(), 0.01);
}

// exp(-t/4 ms) falls to a tenth in 9.2 ms; a band of 300 Hz rings about 5 ms by itself (BandDecayTest).
TEST(Measures, FreeVibrationTellsARingFromAKick) {
  auto ring = statement("free_vibration", 0, 1);
  ring.band = {850, 1150};
  const auto own = signals::bandDecay({0, 4e-5, std::vector<double>(made(1000).signals[0].values), "", ""}, 0.01, 0.05,
                                      {"", 850, 1150})
                       .own;
  EXPECT_NEAR(measure(made(1000), ring).value(), 0.004 * std::log(10) / own, 0.4);
  auto kick = made(1000);
  for (double& value : kick.signals[0].values) value = 0;
  kick.signals[0].values[500] = 80;
  // The time of the impact and of the filter's answer agree to a sample; the least length is one sample.
  EXPECT_NEAR(measure(kick, ring).value(), 1, 0.05);
}

// A line that rings beside the band is not the band's: 784 Hz, which swings in over 5 ms, against 850 to 1150 Hz.
TEST(Measures, FreeVibrationOfALineBesideTheBandIsNotTheBands) {
  auto ring = statement("free_vibration", 2, 1e9);
  ring.band = {850, 1150};
  auto beside = made(784);
  auto& values = beside.signals[0].values;
  for (std::size_t i = 500; i < values.size(); ++i) {
    const double after = beside.time[i] - 0.02;
    values[i] =
        80 * (1 - std::exp(-after / 0.005)) * std::exp(-after / 0.05) * std::sin(2 * std::numbers::pi * 784 * after);
  }
  EXPECT_EQ(measure(beside, ring).value(), 0);
  EXPECT_EQ(judgedOf(ring, {{"a", beside}}).verdict, Verdict::notMet);
}

// A run of 0.6 m shows a line at or below 320 Hz with the longer window: 0.68 m in place of 0.38 m.
TEST(Measures, LowLinesAreSeenThroughALongerWindow) {
  auto low = statement("line", 0, 1), high = low;
  low.near = 300;
  high.near = 1000;
  // Hann parts lines two steps of 1/T from each other.
  EXPECT_NEAR(strongLines(made(300), low)->resolution, 2 * 30 / 0.68, 2);
  EXPECT_NEAR(strongLines(made(300), high)->resolution, 2 * 30 / 0.38, 2);
  EXPECT_NEAR(measure(made(300), low).value(), 300, 22);  // a quarter of the resolution
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
  EXPECT_THAT(judgedOf(statement("maximum", 0, 1), {}).why, HasSubstr("no result of run a"));
  EXPECT_THAT(judgedOf(statement("maximum", 0, 1), {{"a", {}}}).why, HasSubstr("cannot be determined from run a"));
  EXPECT_THAT(judgedOf(statement("wavelength", 0, 1), {{"a", {}}}).why, HasSubstr("cannot be determined from run a"));
  auto paperOnly = statement("elements", 0, 1);
  paperOnly.mesh = "paper";
  EXPECT_THAT(judgedOf(paperOnly, {{"a", {}}}).why, HasSubstr("--mesh paper"));
}

TEST(Judge, TheTableHoldsEveryStatement) {
  auto none = statement("none", 0, 0);
  none.text = "one, with a comma";
  none.reason = "not published";
  const auto csv = judgedCsv(judge(referenceOf({none, statement("maximum", 70, 90)}), {{"a", made(1000)}}, "draft"));
  EXPECT_EQ(csv,
            "section,statement,run,against,at,expected,low,high,value,unit,verdict,at the wheel centre,reason\n"
            ",\"one, with a comma\",a,,axle box,,,,,,not judged,,not published\n"
            ",,a,,axle box,,70,90,80,,met,,\n");
}

// Two decaying waves: lines near 300 and 1000 Hz and no others.
results::RunResult twoLines() {
  auto result = made(1000);
  const auto low = made(300);
  for (std::size_t i = 0; i < result.time.size(); ++i) result.signals[0].values[i] += 0.7 * low.signals[0].values[i];
  return result;
}

TEST(Judge, ALineServesOneStatementOnly) {
  auto first = statement("line", 900, 1100), second = statement("line", 450, 780), third = statement("line", 250, 400);
  first.near = 1034;
  second.near = 700;
  third.near = 300;
  const auto judged = judge(referenceOf({second, first, third}), {{"a", twoLines()}}, "draft");
  EXPECT_EQ(judged[1].verdict, Verdict::met);
  EXPECT_EQ(judged[2].verdict, Verdict::met);
  // Alone, the statement about 700 Hz would take the line at 1000 Hz and print it.
  EXPECT_EQ(judged[0].verdict, Verdict::notMet);
  EXPECT_FALSE(judged[0].value);
  EXPECT_THAT(judged[0].why, HasSubstr("no line of its own"));
}

TEST(Judge, TheWheelCentreStandsBesideAndDoesNotCount) {
  auto result = made(1000, 60);
  auto wheel = result.signals[0];
  wheel.name = "wheel_acceleration_filtered";
  for (double& value : wheel.values) value *= 1.5;
  result.signals.push_back(wheel);
  const auto judged = judgedOf(statement("maximum", 50, 70), {{"a", result}});
  EXPECT_EQ(judged.verdict, Verdict::met);
  EXPECT_DOUBLE_EQ(judged.elsewhere.value(), 90);
  auto there = statement("maximum", 50, 70);
  there.point = wheelCentre;
  EXPECT_EQ(judgedOf(there, {{"a", result}}).verdict, Verdict::notMet);
}

TEST(Judge, TrendsHaveOneBound) {
  auto trend = statement("maximum", 70, 0);
  trend.high = std::numeric_limits<double>::infinity();
  EXPECT_EQ(judgedOf(trend, {{"a", made(1000)}}).verdict, Verdict::met);
  trend.unit = "m/s2";
  EXPECT_EQ(rangeText(trend), "at least 70 m/s²");
  trend.low = 81;
  EXPECT_EQ(judgedOf(trend, {{"a", made(1000)}}).verdict, Verdict::notMet);
}

TEST(Judge, ParametersAreComparedAsValues) {
  results::RunResult result;
  auto description = cases::defaultCase();
  cases::setValue(description, "pad.stiffness", "1300.0");
  cases::setValue(description, "track.length", "12");
  results::setCase(result, description);
  Reference reference;
  reference.parameters = {{"Table 1", "K2", "pad.stiffness", "1300"}, {"2", "length", "track.length", "10"}};
  const auto compared = compareParameters(reference, result);
  ASSERT_EQ(compared.size(), 2u);
  EXPECT_TRUE(compared[0].same);
  EXPECT_FALSE(compared[1].same);
  EXPECT_EQ(compared[1].ours, "12");
  EXPECT_THAT(parametersCsv(compared), HasSubstr("2,length,track.length,10,12,m,no\n"));
}

}  // namespace
}  // namespace squat::statements
