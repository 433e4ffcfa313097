// The scalogram's picture grid against a power that is linear in position and log frequency, where bilinear
// interpolation is exact.
#include <gtest/gtest.h>

#include <cmath>

#include "plots/ScalogramGrid.h"

namespace squat {
namespace {

double power(double position, double frequency) { return 3 + 10 * position + 0.5 * std::log(frequency); }

results::AnalysedRecord linearScalogram(bool descending) {
  results::AnalysedRecord result;
  for (int i = 0; i <= 30; ++i) result.scalogramPosition.push_back(-0.15 + 0.01 * i);
  for (int i = 0; i <= 12; ++i)
    result.scalogramFrequency.push_back(25 * std::pow(2.0, 0.6 * (descending ? 12 - i : i)));
  for (double frequency : result.scalogramFrequency)
    for (double position : result.scalogramPosition) result.scalogramPower.push_back(power(position, frequency));
  result.scalogramTime = result.scalogramPosition;
  return result;
}

TEST(ScalogramGrid, reproducesALinearField) {
  for (bool descending : {false, true}) {
    const auto grid = plots::scalogramGrid(linearScalogram(descending), -0.1, 0.1, 50, 2000);
    ASSERT_FALSE(grid.power.empty());
    for (int row : {0, 17, grid.rows - 1})
      for (int column : {0, 100, grid.columns - 1}) {
        const double position = -0.1 + 0.2 * column / (grid.columns - 1);
        const double frequency = 50 * std::pow(40.0, static_cast<double>(row) / (grid.rows - 1));
        // Round-off of a few operations only.
        EXPECT_NEAR(grid.power[static_cast<std::size_t>(row) * grid.columns + column], power(position, frequency),
                    1e-9);
      }
  }
}

TEST(ScalogramGrid, brokenSizesGiveNothing) {
  auto result = linearScalogram(false);
  result.scalogramPower.pop_back();
  EXPECT_TRUE(plots::scalogramGrid(result, -0.1, 0.1, 50, 2000).power.empty());
  EXPECT_TRUE(plots::scalogramGrid({}, -0.1, 0.1, 50, 2000).power.empty());
  EXPECT_TRUE(plots::scalogramGrid(linearScalogram(false), 5, 6, 50, 2000).power.empty());
}

}  // namespace
}  // namespace squat
