// What was made faster gives the answer that it gave before: within half a percent of the largest acceleration, at
// every sample. The answer of before is frozen in frozen/light-defect-tiny.csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "simulation/RunCase.h"
#include "verification/Seen.h"

namespace squat {
namespace {

struct Frozen {
  std::vector<double> time, acceleration;
};

Frozen readFrozen() {
  std::ifstream file(FROZEN_FOLDER "/light-defect-tiny.csv");
  Frozen frozen;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const auto comma = line.find(',');
    frozen.time.push_back(std::stod(line.substr(0, comma)));
    frozen.acceleration.push_back(std::stod(line.substr(comma + 1)));
  }
  return frozen;
}

struct Faster {
  std::string name, precision, selectiveMassScaling;
};

class SameAnswer : public ::testing::TestWithParam<Faster> {};

TEST_P(SameAnswer, AsBeforeWithinHalfAPercent) {
  const auto frozen = readFrozen();
  ASSERT_GT(frozen.time.size(), 150U);
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = false;
  options.snapshots = false;
  Monitor silent;
  const auto result = simulation::runCase(
      cases::loadCase(
          tests::fixtureCase("light-defect"),
          {"tiny",
           {{"mesh.precision", GetParam().precision}, {"mesh.selective_inertia", GetParam().selectiveMassScaling}}}),
      options, silent);
  const auto& now = *result.signal("aba_filtered");
  ASSERT_EQ(now.size(), frozen.acceleration.size());
  double maximum = 0, peak = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    ASSERT_NEAR(result.time[i], frozen.time[i], 1e-9);
    maximum = std::max(maximum, std::abs(now[i] - frozen.acceleration[i]));
    peak = std::max(peak, std::abs(frozen.acceleration[i]));
  }
  std::printf("%s: largest difference %.3f %% of the peak\n", GetParam().name.c_str(), 100 * maximum / peak);
  EXPECT_GT(peak, 100);
  EXPECT_LT(maximum, 5e-3 * peak);
  // Another instruction set rounds otherwise: what is below a hundredth of a percent is not told apart.
  verification::seen("difference", std::max(0.01, 100 * maximum / peak), "%");
}

INSTANTIATE_TEST_SUITE_P(Ways, SameAnswer,
                         ::testing::Values(Faster{"Double", "double", "false"}, Faster{"Single", "single", "false"},
                                           Faster{"SelectiveMassScaling", "double", "true"},
                                           Faster{"AsByDefault", "single", "true"}),
                         [](const auto& way) { return way.param.name; });

}  // namespace
}  // namespace squat
