// Measured profiles before they are a surface: stretch, points that stand apart, filters. Expected: what medians of
// known shapes are, and the known places of what was put in.
#include "scenario/MeasuredProfile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"
#include "case/ProfileFile.h"
#include "case/Validation.h"
#include "scenario/DefectSurface.h"

namespace squat::cases {
namespace {

using scenario::countedPoints;
using scenario::deepestPlace;
using scenario::pointsApart;
using std::numbers::pi;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;
using Points = std::vector<ProfilePoint>;

constexpr double roundOff = 1e-18;  // of heights of 1e-4 m, a few units in the last place

template <typename Height>
Points sampled(double from, double step, int count, Height&& height) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({from + i * step, height(from + i * step)});
  return points;
}

Defect filtering(ProfileFilter filter, double width) {
  Defect defect;
  defect.filter = filter, defect.filterWidth = width;
  return defect;
}

double dip(double x, double length, double depth) {
  return std::abs(x) < length / 2 ? -depth / 2 * (1 + std::cos(2 * pi * x / length)) : 0;
}

Points noise(unsigned seed, double deviation, int count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, deviation);
  return sampled(0, 0.0005, count, [&](double) { return normal(random); });
}

TEST(MeasuredProfile, AStretchIsInThePositionsOfTheFile) {
  const auto points = sampled(12345, 0.25, 9, [](double) { return 0.0; });
  Defect defect;
  defect.from = 12345.5, defect.to = 12346.25;
  const auto counted = countedPoints(points, defect);
  ASSERT_EQ(counted.size(), 4u);
  EXPECT_EQ(counted.front().position, 12345.5);
  EXPECT_EQ(counted.back().position, 12346.25);
  EXPECT_EQ(countedPoints(points, Defect{}).size(), 9u);
}

// Medians of a straight line are its points, in the middle and at the ends.
TEST(MeasuredProfile, FiltersLeaveStraightLines) {
  const auto line = sampled(0, 0.001, 60, [](double x) { return 1e-3 * x; });
  for (const auto filter : {ProfileFilter::outliers, ProfileFilter::median}) {
    const auto filtered = countedPoints(line, filtering(filter, 0.010));
    for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(filtered[i].height, line[i].height, roundOff) << i;
  }
}

// The median of a window of 16 steps about the bottom of c x^2 / 2 is its height at a quarter of the window.
TEST(MeasuredProfile, TheMedianOfABottomLosesWhatTheHeaderSays) {
  constexpr double curvature = 0.5, step = 0.0005, width = 16 * step;
  const auto bowl = sampled(-0.05, step, 201, [](double x) { return 0.5 * curvature * x * x; });
  const auto filtered = countedPoints(bowl, filtering(ProfileFilter::median, width));
  EXPECT_NEAR(filtered[100].height, curvature * width * width / 32, 1e-12);
  EXPECT_NEAR(countedPoints(bowl, filtering(ProfileFilter::outliers, width))[100].height, 0, 1e-12);
}

// A spike on a slope becomes one of the heights beside it; nothing else changes.
TEST(MeasuredProfile, OutliersAreReplacedAndNothingElse) {
  auto slope = sampled(0, 0.001, 61, [](double x) { return 2e-3 * x; });
  const auto clean = slope;
  slope[30].height += 5e-3, slope[0].height -= 5e-3, slope[60].height += 5e-3;
  const auto filtered = countedPoints(slope, filtering(ProfileFilter::outliers, 0.010));
  for (std::size_t i = 1; i < 60; ++i)
    EXPECT_NEAR(filtered[i].height, clean[i].height, i == 30 ? 2.1e-6 : roundOff) << i;
  // At an end the window has one side only, so that its median is half its length away.
  EXPECT_NEAR(filtered[0].height, clean[0].height, 2e-3 * 0.005);
  EXPECT_NEAR(filtered[60].height, clean[60].height, 2e-3 * 0.005);
}

// The median of 11 normal values scatters by 0.37 of one (its efficiency is 0.66); of 4000 points some 360 are
// independent, so that the estimate scatters by 4 %.
TEST(MeasuredProfile, TheMedianSmoothsNoise) {
  const auto raw = noise(7, 1e-5, 4000);
  double squares = 0;
  for (const auto& point : countedPoints(raw, filtering(ProfileFilter::median, 0.005)))
    squares += point.height * point.height;
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.37e-5, 0.06e-5);
}

TEST(MeasuredProfile, OnlyAPointThatStandsAloneIsApart) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    auto points = noise(seed, 3e-6, 401);
    EXPECT_THAT(pointsApart(points), IsEmpty()) << seed;  // noise reaches 4 of its deviations in 401 values, seldom 5
    points[200].height += 1e-4, points[300].height -= 2e-4;
    EXPECT_THAT(pointsApart(points), UnorderedElementsAre(200, 300)) << seed;
  }
  for (const double step : {0.0005, 0.001, 0.002, 0.005, 0.01}) {  // smooth dips, down to five points, and a cut
    EXPECT_THAT(pointsApart(sampled(-0.1, step, static_cast<int>(0.2 / step) + 1,
                                    [](double x) { return dip(x, 0.05, 1.5e-4); })),
                IsEmpty())
        << step;
    EXPECT_THAT(pointsApart(sampled(-0.1, step, static_cast<int>(0.2 / step) + 1,
                                    [](double x) { return std::abs(x) < 0.0151 ? -1.5e-4 : 0.0; })),
                IsEmpty())
        << step;
  }
  EXPECT_THAT(pointsApart({{0.080, 12e-6},
                           {0.09, 15e-6},
                           {0.1, -7e-5},
                           {0.11, -1.35e-4},
                           {0.12, -6e-5},
                           {0.13, 2e-5},
                           {0.14, -1e-5},
                           {0.15, 3e-5}}),
              IsEmpty());
}

// A dip of 0.2 mm at 7.3 m on waves of 3 mm and 9 m: the mean over 0.5 m follows them to 15 um, and holds 1/20 of the
// dip.
TEST(MeasuredProfile, TheDeepestPlaceIsBelowTheLevelAboutIt) {
  auto scan =
      sampled(0, 0.001, 20001, [](double x) { return 3e-3 * std::sin(2 * pi * x / 9) + dip(x - 7.3, 0.05, 2e-4); });
  scan[3000].height -= 0.02;  // a point alone does not count
  const auto deepest = deepestPlace(scan);
  EXPECT_NEAR(deepest.position, 7.3, 0.002);
  EXPECT_NEAR(deepest.depth, 2e-4, 3e-5);
}

CaseDescription caseOf(const Points& points) {
  auto description = defaultCase();
  description.defect.shape = DefectShape::profile;
  description.defect.points = points;
  return description;
}

std::string textOf(const std::vector<CaseProblem>& problems) {
  std::string all;
  for (const auto& one : problems) all += one.key + ": " + one.allowed + ": " + one.advice + "\n";
  return all;
}

Points dipWithSpike() {
  auto points = sampled(-0.1, 0.0005, 401, [](double x) { return dip(x, 0.06, 2e-4); });
  points[318].height += 2e-4;  // at 59 mm
  return points;
}

TEST(MeasuredProfile, APointApartIsNamedAndTheFilterTakesItAway) {
  auto description = caseOf(dipWithSpike());
  const auto found = textOf(validate(description).warnings) + textOf(validate(description).problems);
  EXPECT_THAT(found, AllOf(HasSubstr("59 mm"), HasSubstr("0.2 mm above"), HasSubstr("outliers")));
  description.defect.filter = ProfileFilter::outliers;
  EXPECT_EQ(textOf(validate(description).warnings) + textOf(validate(description).problems), "");
  const DefectSurface surface(description.defect);
  EXPECT_NEAR(surface.depth(), 2e-4, roundOff);
  EXPECT_NEAR(surface.height(0.059), 0, roundOff);
}

// Noise of 30 um every 0.5 mm is steep everywhere: no point of it is apart.
TEST(MeasuredProfile, NoiseIsCalledNoise) {
  auto points = noise(11, 3e-5, 401);
  for (auto& point : points) point.height += dip(point.position - 0.1, 0.06, 2e-4);
  auto description = caseOf(points);
  const auto found = textOf(validate(description).warnings) + textOf(validate(description).problems);
  EXPECT_THAT(found, AllOf(HasSubstr("noise"), HasSubstr("median"), Not(HasSubstr("outliers"))));
  description.defect.filter = ProfileFilter::median;
  // 11 values leave 0.37 of the noise, at the ends, whose line is the level, 0.5: within three of them together.
  EXPECT_NEAR(DefectSurface(description.defect).depth(), 2e-4, 4e-5);
}

TEST(MeasuredProfile, WhatDoesNotFitIsSaid) {
  auto wide = caseOf(dipWithSpike());
  wide.defect.filter = ProfileFilter::median, wide.defect.filterWidth = 0.040;
  EXPECT_THAT(textOf(validate(wide).warnings), AllOf(HasSubstr("0.2 mm without it"), HasSubstr("shorter")));
  wide.defect.filterWidth = 0.001;
  EXPECT_THAT(textOf(validate(wide).problems), AllOf(HasSubstr("defect.filter_width"), HasSubstr("2 mm")));
  auto elsewhere = caseOf(dipWithSpike());
  elsewhere.defect.from = 5, elsewhere.defect.to = 6;
  EXPECT_THAT(textOf(validate(elsewhere).problems), AllOf(HasSubstr("defect.from"), HasSubstr("-0.1 to 0.1 m")));
  elsewhere.defect.to = 4;
  EXPECT_THAT(textOf(validate(elsewhere).problems), AllOf(HasSubstr("defect.to"), HasSubstr("at least 5 m")));
}

// A ride over 20 m: the message tells which stretch the deepest defect is.
TEST(MeasuredProfile, ALongScanIsRefusedWithTheStretchToTake) {
  auto description =
      caseOf(sampled(0, 0.001, 20001, [](double x) { return 5e-5 * std::sin(x) + dip(x - 7.3, 0.05, 2e-4); }));
  EXPECT_THAT(textOf(validate(description).problems),
              AllOf(HasSubstr("20 m long"), HasSubstr("defect.from = 7.05"), HasSubstr("defect.to = 7.55")));
  description.defect.from = 7.05, description.defect.to = 7.55;
  EXPECT_EQ(textOf(validate(description).problems) + textOf(validate(description).warnings), "");
  // The slow wave bends by 5e-5 m / m^2 (0.25 m)^2 / 2 = 1.6 um within the stretch, whose ends are its level.
  EXPECT_NEAR(DefectSurface(description.defect).depth(), 2e-4, 2e-6);
}

}  // namespace
}  // namespace squat::cases
