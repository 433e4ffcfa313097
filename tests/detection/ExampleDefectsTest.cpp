// Irregularities that are no squats: all kinds, of the dimensions that the header states.
#include "detection/ExampleDefects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace squat::detection {
namespace {

TEST(ExampleOthers, HaveAllKinds) {
  std::map<Kind, int> count;
  for (const auto& example : exampleOthers(80, 5)) ++count[example.kind];
  EXPECT_EQ(count[Kind::joint], 30);
  EXPECT_EQ(count[Kind::weld], 20);
  EXPECT_EQ(count[Kind::corrugation], 10);
  EXPECT_EQ(count[Kind::other], 10);
  EXPECT_EQ(count[Kind::squat], 10);
}

// Each begins and ends on the undisturbed rail, within 1.5 m: a step there would be one more irregularity.
TEST(ExampleOthers, LeaveTheRailAsItWas) {
  for (const auto& example : exampleOthers(400, 6)) {
    const auto& points = example.defect.points;
    ASSERT_GE(points.size(), 20U);
    EXPECT_NEAR(points.front().height, 0, 1e-9);
    EXPECT_NEAR(points.back().height, 0, 1e-9);
    EXPECT_LT(points.back().position - points.front().position, 1.5);
    EXPECT_NEAR(example.before + example.behind, points.back().position - points.front().position, 1e-9);
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [](const auto& a, const auto& b) { return a.height < b.height; });
    EXPECT_GT(high->height - low->height, 5e-6) << "it would not be felt";
    EXPECT_LT(high->height - low->height, 5e-3);
  }
}

// Crests of corrugation are 25 to 80 mm apart: twice the distance between changes of sign.
TEST(ExampleOthers, CorrugationHasTheWavelengthsStated) {
  for (const auto& example : exampleOthers(400, 7)) {
    if (example.kind != Kind::corrugation) continue;
    std::vector<double> crossings;
    const auto& points = example.defect.points;
    for (std::size_t i = 1; i < points.size(); ++i)
      if ((points[i - 1].height < 0) != (points[i].height < 0)) crossings.push_back(points[i].position);
    ASSERT_GE(crossings.size(), 4U) << "three waves change sign five times, less what fades";
    const double wave = 2 * (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    EXPECT_GT(wave, 24e-3);
    EXPECT_LT(wave, 82e-3);
  }
}

}  // namespace
}  // namespace squat::detection
