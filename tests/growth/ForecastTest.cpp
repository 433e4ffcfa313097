// Growths under uncertain inputs, put together: values by hand.
#include "growth/Forecast.h"

#include <gmock/gmock.h>

#include <cmath>

namespace squat::growth {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Growth growthWith(const std::vector<std::pair<double, double>>& depths) {  // [Mt], [mm]
  Growth growth;
  for (const auto& [tonnage, depth] : depths) {
    growth.stages.emplace_back();
    growth.stages.back().tonnage = 1e9 * tonnage, growth.stages.back().depth = 1e-3 * depth;
  }
  return growth;
}

std::vector<ForecastPoint> at(const std::vector<double>& megatonnes) {
  std::vector<ForecastPoint> points;
  for (const double tonnage : megatonnes) points.push_back({1e9 * tonnage, false});
  return points;
}

TEST(Forecast, DepthsBetweenStagesAreLinear) {
  const auto depths = depthsAt(growthWith({{0, 0.1}, {2, 0.2}, {4, 0.6}}), at({0, 1, 3, 4, 5}));
  ASSERT_EQ(depths.size(), 5u);
  EXPECT_NEAR(depths[0], 0.10e-3, 1e-15);
  EXPECT_NEAR(depths[1], 0.15e-3, 1e-15);
  EXPECT_NEAR(depths[2], 0.40e-3, 1e-15);
  EXPECT_NEAR(depths[3], 0.60e-3, 1e-15);
  EXPECT_TRUE(std::isnan(depths[4])) << "it has not come so far";
}

// Two stages of the same tonnage: before and after the grinding, which may come a few wheelsets late or a millionth
// early.
TEST(Forecast, AGrindingHasADepthBeforeAndAfterIt) {
  for (const double tonnage : {2.0, 2.001, 2 - 1e-6}) {
    auto growth = growthWith({{0, 0.1}, {tonnage, 0.3}, {tonnage, 0.1}, {4, 0.2}});
    growth.stages[2].ground = true;
    const auto depths = depthsAt(growth, {{2e9, true}, {2e9, false}});
    EXPECT_THAT(depths, ElementsAre(DoubleNear(0.3e-3, 1e-15), DoubleNear(0.1e-3, 1e-15))) << tonnage;
  }
  auto growth = growthWith({{0, 0.1}, {2, 0.3}, {2, 0.1}, {4, 0.2}});
  growth.stages[2].ground = true;
  const auto depths = depthsAt(growth, {{1e9, false}, {2e9, true}, {2e9, false}, {3e9, false}});
  EXPECT_THAT(depths, ElementsAre(DoubleNear(0.2e-3, 1e-15), DoubleNear(0.3e-3, 1e-15), DoubleNear(0.1e-3, 1e-15),
                                  DoubleNear(0.15e-3, 1e-15)));
  EXPECT_NEAR(*firstPassage(growth, 0.25e-3), 1.5e9, 1);
  EXPECT_FALSE(firstPassage(growth, 0.35e-3));
}

TEST(Forecast, PointsStandBeforeAndAfterGrindings) {
  GrowthOptions options;
  options.tonnage = 20e9, options.grindings = {{0.2e-3, 10e9}, {0.2e-3, 10.5e9}};
  const auto points = forecastPoints(options);
  ASSERT_EQ(points.size(), 23u);
  EXPECT_TRUE(points[10].toBeGround);
  EXPECT_FALSE(points[11].toBeGround);
  EXPECT_EQ(points[10].tonnage, points[11].tonnage);
  EXPECT_EQ(points[12].tonnage, 10.5e9);
}

TEST(Forecast, BandAndPassages) {
  const double none = std::nan("");
  const auto forecast = forecastFrom(
      at({0, 1, 2}), {{{1e-4, 2e-4, 4e-4}, 1.5e9}, {{1e-4, 3e-4, 5e-4}, 1e9}, {{1e-4, 1e-4, none}, {}}}, 3e-4, 4);
  EXPECT_THAT(forecast.lowest, ElementsAre(1e-4, 1e-4, 4e-4));
  EXPECT_THAT(forecast.median, ElementsAre(1e-4, 2e-4, DoubleNear(4.5e-4, 1e-18)));
  EXPECT_THAT(forecast.highest, ElementsAre(1e-4, 3e-4, 5e-4));
  EXPECT_THAT(forecast.passedAt, ElementsAre(1e9, 1.5e9));
  const auto text = forecastText(forecast);
  EXPECT_THAT(text, HasSubstr("Forecast from 3 of 4 growths"));
  EXPECT_THAT(text, HasSubstr("0.400 to 0.500 mm"));
  EXPECT_THAT(text, HasSubstr("2 of the growths reach 0.3 mm, the first after 1.00 Mt."));
  EXPECT_THAT(forecastTable(forecast), HasSubstr("\n1,0,0.1,0.2,0.3"));
}

TEST(Forecast, ALimitThatIsReachedByAllOrNoneIsSaid) {
  EXPECT_THAT(forecastText(forecastFrom(at({0, 1}), {{{1e-4, 2e-4}, {}}, {{2e-4, 3e-4}, {}}}, 5e-4, 2)),
              HasSubstr("None of the growths reaches 0.5 mm."));
  EXPECT_THAT(forecastText(forecastFrom(at({0, 1}), {{{1e-4, 2e-4}, 1e9}, {{2e-4, 2e-4}, 0}}, 2e-4, 2)),
              HasSubstr("All growths reach 0.2 mm, the first after 0.00 Mt, half of them by 0.50 Mt, the last after "
                        "1.00 Mt."));
  EXPECT_THAT(forecastText(forecastFrom(at({0, 1}), {}, 2e-4, 2)), HasSubstr("none of 2 growths"));
}

}  // namespace
}  // namespace squat::growth
