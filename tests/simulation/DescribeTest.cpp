// What a result tells beside its signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "simulation/Describe.h"

namespace squat::simulation {
namespace {

double hertz(const std::string& wheelModulus, const std::string& name) {
  const auto model = model::buildModel(
      cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"wheelset.young_modulus", wheelModulus}}}));
  results::RunResult result;
  describeEquilibrium(model, {}, result);
  for (const auto& scalar : result.equilibrium)
    if (scalar.name == name) return scalar.value;
  return 0;
}

// Johnson, Contact Mechanics (1985), section 4.2: p0 goes with E*^(2/3), the approach with E*^(-2/3). A wheel four
// times as stiff as the rail: E* is 2 / (1 + 1/4) = 1.6 times that of two alike.
TEST(Describe, HertzKnowsBothModuli) {
  EXPECT_NEAR(hertz("840", "hertz_peak_pressure") / hertz("210", "hertz_peak_pressure"), std::pow(1.6, 2.0 / 3), 1e-9);
  EXPECT_NEAR(hertz("840", "hertz_approach") / hertz("210", "hertz_approach"), std::pow(1.6, -2.0 / 3), 1e-9);
}

// At 8 m/s and 200 kHz the window of 0.38 m holds 9500 samples, more than the usual length of the transform.
TEST(Describe, SlowRunsHaveSpectraToo) {
  const auto description =
      cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny", {{"output.rate", "200"}, {"motion.speed", "8"}}});
  results::RunResult result;
  result.speed = 8;
  std::vector<double> tone;
  for (int i = 0; i < 12000; ++i) {
    const double t = i / 200e3;
    result.time.push_back(t), result.position.push_back(8 * t - 0.15);
    tone.push_back(std::sin(2 * std::numbers::pi * 500 * t));
  }
  result.signals = {{"aba_filtered", "m/s2", "", tone}, {"wheel_acceleration_filtered", "m/s2", "", tone}};
  EXPECT_EQ(addSpectra(cases::resolve(description), result), "");
  ASSERT_FALSE(result.psd.empty());
  EXPECT_FALSE(result.scalogramPower.empty());
  const auto peak = std::max_element(result.psd.begin(), result.psd.end()) - result.psd.begin();
  EXPECT_NEAR(result.frequency[static_cast<std::size_t>(peak)], 500, result.frequency[1]);
}

// A low tone lies below the cone of influence all along. Behind a defect that is worth a remark; on a smooth rail under
// a round wheel there is nothing to mind.
TEST(Describe, TheConeIsRemarkedOnWhereSomethingShakesTheWheel) {
  const auto remark = [](const std::string& name) {
    const auto description = cases::loadCase(tests::fixtureCase(name), {"tiny", {}});
    results::RunResult result;
    result.speed = description.motion.speed;
    std::vector<double> tone;
    for (int i = 0; i < 400; ++i) {
      const double t = i / 25e3;
      result.time.push_back(t), result.position.push_back(result.speed * t - 0.15);
      tone.push_back(std::sin(2 * std::numbers::pi * 60 * t));
    }
    result.signals = {{"aba_filtered", "m/s2", "", tone}, {"wheel_acceleration_filtered", "m/s2", "", tone}};
    return addSpectra(cases::resolve(description), result);
  };
  EXPECT_THAT(remark("light-defect"), testing::HasSubstr("cone of influence"));
  EXPECT_EQ(remark("smooth-rail"), "");
}

// At 150 m/s and 16 kHz a sample every 9.4 mm, from -0.5 m on.
TEST(Describe, ARecordTooShortForSpectraSaysWhatToDo) {
  const auto description =
      cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny", {{"output.rate", "16"}, {"motion.speed", "150"}}});
  results::RunResult result;
  result.speed = 150;
  for (int i = 0; i < 70; ++i) result.time.push_back(i / 16e3), result.position.push_back(150 * i / 16e3 - 0.5);
  result.signals = {{"aba_filtered", "m/s2", "", result.time},
                    {"wheel_acceleration_filtered", "m/s2", "", result.time}};
  const auto reasonWith = [&](std::size_t samples) {
    results::RunResult part = result;
    part.time.resize(samples), part.position.resize(samples);
    for (auto& channel : part.signals) channel.values.resize(samples);
    return addSpectra(cases::resolve(description), part);
  };
  EXPECT_THAT(reasonWith(63), testing::HasSubstr("63 samples in the record, at least 64"));
  EXPECT_THAT(reasonWith(64), testing::HasSubstr("21 samples from 0.1 m before"));  // the 44th lies at -0.097 m
  EXPECT_EQ(reasonWith(0).find("no spectra"), 0u);
}

}  // namespace
}  // namespace squat::simulation
