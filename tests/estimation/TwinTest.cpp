// The twin experiment: the profile of a known run is found again from its own signal with noise, by the vehicle that
// rolled and by another.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include "case/Resolve.h"
#include "estimation/Estimation.h"
#include "results/SampleResult.h"
#include "simulation/RunCase.h"
#include "verification/Seen.h"

namespace squat::estimation {
namespace {

using squat::tests::TemporaryFolder;

constexpr double kRadius = 0.46, kDepth = 0.15e-3;

cases::CaseOverrides overridesWith(const std::string& key = {}, const std::string& value = {}) {
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  if (!key.empty()) overrides.values.emplace_back(key, value);
  return overrides;
}

// A smooth dip of 50 mm, which the wheel follows to its bottom, on the track of the shipped light defect.
const cases::CaseDescription& truth() {
  static const auto description = [] {
    auto overrides = overridesWith("defect.shape", "cosine");
    overrides.values.emplace_back("defect.length", "50");
    overrides.values.emplace_back("defect.depth", "0.15");
    overrides.values.emplace_back("motion.beyond", "0.3");
    return cases::loadCase("light-defect", overrides);
  }();
  return description;
}

// White noise; below 2 of 12.5 kHz its deviation is a tenth of the event's root mean square.
void writeNoisy(const results::RunResult& result, const std::string& path) {
  const auto& aba = *result.signal("aba");
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < aba.size(); ++i)
    if (result.position[i] > -0.03 && result.position[i] < 0.13) squares += aba[i] * aba[i], ++count;
  const double deviation = 0.1 * std::sqrt(squares / static_cast<double>(count)) * std::sqrt(12.5 / 2);
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0, deviation);
  std::ofstream file(path);
  file.precision(12);
  file << "time [s],position [m],aba [m/s2]\n";
  for (std::size_t i = 0; i < aba.size(); ++i)
    file << result.time[i] << ',' << result.position[i] << ',' << aba[i] + noise(engine) << '\n';
}

Estimate estimateFrom(const cases::CaseOverrides& overrides) {
  const TemporaryFolder folder;
  simulation::RunOptions options;
  options.wheelsetModes = false, options.snapshots = false;
  Monitor monitor;
  writeNoisy(simulation::runCase(truth(), options, monitor), folder / "passage.csv");
  EstimateDefinition definition;
  definition.caseName = "light-defect", definition.overrides = overrides;
  definition.files = {folder / "passage.csv"};
  EstimateOptions search;
  search.jobs = 2;
  return estimateProfile(definition, search, monitor);
}

// [m] Root mean square between the paths of a rigid wheel, the estimate shifted to where they differ least: the deepest
// sample of a noisy profile is not its middle.
double pathDifference(const cases::CaseDescription& estimated) {
  constexpr double first = -0.04, last = 0.04, step = 1e-3;
  const auto pathOf = [](const cases::CaseDescription& description, double shift) {
    return cases::rigidWheelPath(cases::surfaceOf(description), kRadius, first + shift, last + shift, step);
  };
  const auto wanted = pathOf(truth(), 0);
  double least = 1;
  for (double shift = -4e-3; shift <= 4e-3; shift += 0.25e-3) {
    const auto found = pathOf(estimated, shift);
    double squares = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) squares += std::pow(found[i].height - wanted[i].height, 2);
    least = std::min(least, std::sqrt(squares / static_cast<double>(wanted.size())));
  }
  return least;
}

// Promised to users: depth within 10 %, path within 10 % of the depth.
TEST(ProfileTwin, IsFoundByItsOwnVehicle) {
  const auto estimate = estimateFrom(overridesWith());
  ASSERT_TRUE(estimate.complete);
  const double path = pathDifference(estimate.description);
  EXPECT_NEAR(estimate.depth.value, kDepth, 0.1 * kDepth);
  EXPECT_LT(path, 0.1 * kDepth);
  verification::seenDeviation("depth", estimate.depth.value, kDepth);
  verification::seen("path", 100 * path / kDepth, "% of the depth");
  std::printf("depth %.1f um, path %.1f um\n", 1e6 * estimate.depth.value, 1e6 * path);
  EXPECT_LE(estimate.depth.low, kDepth);
  EXPECT_GE(estimate.depth.high, kDepth);
}

// Another wheelset asks for other heights. That the record is not explained is said, and the range holds the truth.
TEST(ProfileTwin, LiesInTheRangeOfAnotherWheelset) {
  const auto estimate = estimateFrom(overridesWith("wheelset.preset", "trailer"));
  ASSERT_TRUE(estimate.complete);
  std::printf("depth %.1f to %.1f um\n", 1e6 * estimate.depth.low, 1e6 * estimate.depth.high);
  EXPECT_GT(estimate.misfit, 1.25) << "times the noise: what estimate calls not explained";
  EXPECT_LE(estimate.depth.low, kDepth);
  EXPECT_GE(estimate.depth.high, kDepth);
}

}  // namespace
}  // namespace squat::estimation
