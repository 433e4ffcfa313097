// A run filtered through the settings of its figures: two tones whose shares after a filter are known in closed form.
#include "analysis/SignalViews.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "signals/SignalError.h"

namespace squat::analysis {
namespace {

constexpr double rate = 25000, speed = 30;

// 0.6 m at 30 m/s: 1 m/s2 at 300 and at 1000 Hz.
results::RunResult twoTones() {
  results::RunResult result;
  std::vector<double> values;
  for (std::size_t i = 0; i < 500; ++i) {
    const double time = static_cast<double>(i) / rate;
    result.time.push_back(time);
    result.position.push_back(-0.2 + speed * time);
    values.push_back(std::sin(2 * std::numbers::pi * 300 * time) + std::sin(2 * std::numbers::pi * 1000 * time));
  }
  result.signals = {{"aba", "m/s2", {}, values}, {"aba_filtered", "m/s2", {}, values}};
  result.speed = speed;
  result.psdFrom = -0.1, result.psdTo = 0.28;
  return result;
}

// Of the density in the lines about a frequency, which leak by 1 / 0.38 m * 30 m/s = 79 Hz to each side.
double powerNear(const results::RunResult& result, double frequency) {
  double power = 0;
  for (std::size_t i = 1; i < result.frequency.size(); ++i)
    if (std::abs(result.frequency[i] - frequency) < 160)
      power += result.psd[i] * (result.frequency[i] - result.frequency[i - 1]);
  return power;
}

// Butterworth of order 4 forward and back: the power of a tone falls by (1 + (f / cut-off)^8)^-2.
double shareLeft(double frequency, double cutoff) { return std::pow(1 + std::pow(frequency / cutoff, 8), -2); }

TEST(SignalViews, ALowerCutOffTakesTheHighToneAway) {
  std::string problem;
  FigureSettings settings;
  settings.cutoff = 800;
  const auto filtered = resultThrough(settings, twoTones(), problem);
  EXPECT_EQ(problem, "");
  // A tone of amplitude 1 has the power 1/2. A Hann window of 12 periods of the record leaks 1 %, and the record ends
  // within the reach of the filter.
  EXPECT_NEAR(powerNear(*filtered, 300), 0.5 * shareLeft(300, 800), 0.02);
  EXPECT_NEAR(powerNear(*filtered, 1000), 0.5 * shareLeft(1000, 800), 0.02 * 0.5);
  settings.cutoff = 5000;
  EXPECT_NEAR(powerNear(*resultThrough(settings, twoTones(), problem), 1000), 0.5, 0.02);
}

TEST(SignalViews, TheSectionIsThatOfTheRunUnlessItIsChosen) {
  std::string problem;
  FigureSettings settings;
  const auto ofRun = resultThrough(settings, twoTones(), problem);
  settings.section = {-0.1, 0.28};
  EXPECT_EQ(resultThrough(settings, twoTones(), problem)->psd, ofRun->psd);
  // The density of a tone is its power over 1.5 lines: half as much where the section is half as long. The tones leak
  // into each other by 1 %.
  settings.section->to = 0.09;
  const auto half = resultThrough(settings, twoTones(), problem);
  const auto largest = [](const auto& result) { return *std::max_element(result->psd.begin(), result->psd.end()); };
  EXPECT_NEAR(largest(half) / largest(ofRun), 0.5, 0.02);
  EXPECT_EQ(half->psdTo, 0.28) << "what other figures show is the run's";
}

TEST(SignalViews, WhatCannotBeDoneIsSaidAndTheOldStays) {
  std::string problem;
  auto result = twoTones();
  result.frequency = {0, 10}, result.psd = {3, 4};
  FigureSettings settings;
  settings.cutoff = 13000;  // above half of 25 kHz
  EXPECT_EQ(resultThrough(settings, result, problem)->psd, result.psd);
  EXPECT_EQ(problem, "a filter edge of 13000 Hz needs a sampling rate above 26000 Hz; this one is 25000 Hz");
  settings.cutoff = 500;
  settings.section = {0.8, 0.9};  // behind the end: the filter has nothing to do with it
  const auto filtered = resultThrough(settings, result, problem);
  EXPECT_EQ(problem,
            "Spectrum not updated: the section from 800 mm to 900 mm lies outside the record, which extends from -200 "
            "mm to 399 mm");
  EXPECT_EQ(filtered->psd, result.psd);
  EXPECT_NE(*filtered->signal("aba_filtered"), *result.signal("aba_filtered"));
  EXPECT_EQ(*filtered->signal("aba"), *result.signal("aba"));
}

TEST(SignalViews, ScalesOfSpectraAreNamedInAnyCase) {
  EXPECT_EQ(spectrumScaleNamed("db"), SpectrumScale::decibel);
  EXPECT_EQ(spectrumScaleNamed("Third-Octaves"), SpectrumScale::thirdOctaves);
  EXPECT_EQ(spectrumScaleNamed("cubic"), std::nullopt);
  EXPECT_EQ(nameOf(SpectrumScale::logarithmic), "log");
}

}  // namespace
}  // namespace squat::analysis
