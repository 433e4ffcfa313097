// Growths under uncertain inputs, put together: values by hand.
#include "growth/Forecast.h"

#include <gmock/gmock.h>

#include <cmath>

namespace squat::growth {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Growth growthWith(std::vector<std::pair<double, double>> depths) {  // [Mt], [mm]
  Growth growth;
  for (const auto& [tonnage, depth] : depths) {
    growth.stages.emplace_back();
    growth.stages.back().tonnage = 1e9 * tonnage, growth.stages.back().depth = 1e-3 * depth;
  }
  return growth;
}

TEST(Forecast, DepthsBetweenStagesAreLinear) {
  const auto depths = depthsAt(growthWith({{0, 0.1}, {2, 0.2}, {4, 0.6}}), {0, 1e9, 3e9, 4e9, 5e9});
  ASSERT_EQ(depths.size(), 5u);
  EXPECT_NEAR(depths[0], 0.10e-3, 1e-15);
  EXPECT_NEAR(depths[1], 0.15e-3, 1e-15);
  EXPECT_NEAR(depths[2], 0.40e-3, 1e-15);
  EXPECT_NEAR(depths[3], 0.60e-3, 1e-15);
  EXPECT_TRUE(std::isnan(depths[4])) << "it has not come so far";
}

// Two stages of the same tonnage: before and after the grinding.
TEST(Forecast, WhereTheRailWasGroundTheDepthIsThatAfterIt) {
  const auto depths = depthsAt(growthWith({{0, 0.1}, {2, 0.3}, {2, 0.1}, {4, 0.2}}), {1e9, 2e9, 3e9});
  EXPECT_THAT(depths, ElementsAre(DoubleNear(0.2e-3, 1e-15), DoubleNear(0.1e-3, 1e-15), DoubleNear(0.15e-3, 1e-15)));
}

TEST(Forecast, BandAndPassages) {
  const double none = std::nan("");
  const auto forecast = forecastFrom({0, 1e9, 2e9}, {{1e-4, 2e-4, 4e-4}, {1e-4, 3e-4, 5e-4}, {1e-4, 1e-4, none}}, 3e-4);
  EXPECT_THAT(forecast.lowest, ElementsAre(1e-4, 1e-4, 4e-4));
  EXPECT_THAT(forecast.median, ElementsAre(1e-4, 2e-4, DoubleNear(4.5e-4, 1e-18)));
  EXPECT_THAT(forecast.highest, ElementsAre(1e-4, 3e-4, 5e-4));
  EXPECT_THAT(forecast.passedAt, ElementsAre(DoubleNear(1e9, 1), DoubleNear(1.5e9, 1)));
  const auto text = forecastText(forecast);
  EXPECT_THAT(text, HasSubstr("0.400 to 0.500 mm"));
  EXPECT_THAT(text, HasSubstr("probability of 50 %"));  // (3 - 1) / (3 + 1)
  EXPECT_THAT(text, HasSubstr("2 of the growths pass 0.30 mm, the first after 1.00 Mt."));
  EXPECT_THAT(forecastTable(forecast), HasSubstr("\n1,0.1,0.2,0.3"));
}

TEST(Forecast, ALimitThatIsPassedAtOnceOrNeverIsSaid) {
  EXPECT_THAT(forecastText(forecastFrom({0, 1e9}, {{1e-4, 2e-4}, {2e-4, 3e-4}}, 5e-4)),
              HasSubstr("None of the growths passes 0.50 mm."));
  EXPECT_THAT(
      forecastText(forecastFrom({0, 1e9}, {{1e-4, 2e-4}, {2e-4, 2e-4}}, 2e-4)),
      HasSubstr("All growths pass 0.20 mm, the first after 0.00 Mt, half of them by 0.50 Mt, the last after 1.00 Mt."));
}

}  // namespace
}  // namespace squat::growth
