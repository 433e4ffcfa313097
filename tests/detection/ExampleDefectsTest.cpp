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

// Both sides of a joint meet at one depth but for the step stated, 0.3 mm; some lie on crushed ballast.
TEST(ExampleOthers, EndsOfJointsMeet) {
  int crushed = 0, joints = 0;
  for (const auto& example : exampleOthers(400, 8)) {
    if (example.kind != Kind::joint) continue;
    ++joints;
    crushed += example.support < 1;
    EXPECT_GE(example.support, 0.15);
    const auto& points = example.defect.points;
    // Just outside the largest gap, 20 mm, each side has risen by 0.1 mm or so (11 mm at half of 20 mrad); 0.3 mm of
    // step and 0.3 mm of batter are stated.
    const auto heightAt = [&](double x) {
      return std::min_element(
                 points.begin(), points.end(),
                 [x](const auto& a, const auto& b) { return std::abs(a.position - x) < std::abs(b.position - x); })
          ->height;
    };
    EXPECT_LT(std::abs(heightAt(-0.011) - heightAt(0.011)), 0.8e-3);
  }
  EXPECT_NEAR(1.0 * crushed / joints, (2 * 0.4 + 0.2) / 3, 0.1) << "of 150, three standard deviations";
}

// The chord of a flat of length L lies L^2/8R below the circle; worn ones are shallower than their length would allow.
TEST(ExampleFlats, AreChordsOrWornOnes) {
  for (const auto& example : exampleFlats(100, 3)) {
    EXPECT_EQ(example.kind, Kind::flat);
    const auto& points = example.defect.points;
    const auto lowest = std::min_element(points.begin(), points.end(),
                                         [](const auto& a, const auto& b) { return a.height < b.height; });
    EXPECT_NEAR(lowest->position, 0, 1e-3);
    double length = 0;
    for (const auto& point : points)
      if (point.height < -1e-9) length = std::max(length, 2 * std::abs(point.position) + 2e-3);
    EXPECT_LE(-lowest->height, length * length / (8 * 0.46) + 1e-6);
    EXPECT_GE(-lowest->height, 0.6 * 0.015 * 0.015 / (8 * 0.46) - 1e-6);
    EXPECT_LE(-lowest->height, 0.060 * 0.060 / (8 * 0.46) + 1e-6);
    EXPECT_EQ(points.front().height, 0);
    EXPECT_EQ(points.back().height, 0);
  }
}

}  // namespace
}  // namespace squat::detection
