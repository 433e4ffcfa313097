// Shapes of the defect: heights of the surface that the wheel rolls over, against the formulas of DefectSurface.h.
// Tolerance: a few units in the last place of heights of 1e-4 m.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/DurableFile.h"
#include "keys/Keys.h"
#include "results/SampleResult.h"

namespace squat {
namespace {

using tests::scenarioWith;
using tests::Values;

constexpr double roundOff = 1e-17;  // [m]

scenario::DefectSurface surfaceOf(const Values& values) { return scenarioWith(values).defectSurface; }

double cosineDip(double x, double length, double depth) {
  return -depth / 2 * (1 + std::cos(2 * std::numbers::pi * x / length));
}

TEST(DefectKeys, CosineHasLengthAndDepth) {
  const auto surface = surfaceOf({{"defect.shape", "cosine"}, {"defect.length", "60"}, {"defect.depth", "0.2"}});
  for (const double x : {-0.029, -0.01, 0.0, 0.015}) EXPECT_NEAR(surface.height(x), cosineDip(x, 0.06, 2e-4), roundOff);
  EXPECT_NEAR(surface.first(), -0.03, 1e-12);
  EXPECT_NEAR(surface.last(), 0.03, 1e-12);
  EXPECT_EQ(surfaceOf({{"defect.shape", "none"}}).depth(), 0);
}

// The floor of a cut of 40 mm begins behind its ramp of 8 mm.
TEST(DefectKeys, CutHasRamps) {
  const auto surface =
      surfaceOf({{"defect.shape", "cut"}, {"defect.length", "40"}, {"defect.depth", "0.1"}, {"defect.ramp", "8"}});
  const double from = surface.first();
  EXPECT_NEAR(surface.last() - from, 0.04, 1e-12);
  EXPECT_NEAR(surface.height(from + 0.004), -5e-5, 1e-15);
  EXPECT_NEAR(surface.height(from + 0.0079), -1e-4 * 7.9 / 8, 1e-15);
  EXPECT_NEAR(surface.height(from + 0.0081), -1e-4, roundOff);
}

// Between two bottoms half the length apart a ridge of 0.6 of the depth.
TEST(DefectKeys, WShapeHasARidge) {
  const auto surface = surfaceOf(
      {{"defect.shape", "w-shape"}, {"defect.length", "80"}, {"defect.depth", "0.1"}, {"defect.middle_height", "0.6"}});
  EXPECT_NEAR(surface.height(0), -1e-4, roundOff);
  EXPECT_NEAR(surface.height(0.02), -1e-4 * (1 - 0.6), 1e-15);
  EXPECT_NEAR(surface.height(0.04), -1e-4, 1e-15);
}

TEST(DefectKeys, WavesFollowTheDip) {
  const auto surface = surfaceOf({{"defect.shape", "dip-with-wave"},
                                  {"defect.length", "50"},
                                  {"defect.wave_length", "30"},
                                  {"defect.wave_depth", "0.06"},
                                  {"defect.wave_count", "3"}});
  EXPECT_NEAR(surface.last(), 0.025 + 3 * 0.03, 1e-12);
  for (int wave = 0; wave < 3; ++wave) EXPECT_NEAR(surface.height(0.025 + 0.03 * wave + 0.015), -6e-5, 1e-15) << wave;
  EXPECT_NEAR(surface.height(0.025 + 0.0075), -3e-5, 1e-15);
}

// 1 - (y / half width)^2 about the centre; uniform otherwise.
TEST(DefectKeys, AcrossTheRailAParabola) {
  const Values dip{{"defect.shape", "cosine"}, {"defect.depth", "0.1"}};
  Values parabola = dip;
  parabola.insert(parabola.end(),
                  {{"defect.lateral", "parabolic"}, {"defect.half_width", "12"}, {"defect.lateral_centre", "3"}});
  const auto surface = surfaceOf(parabola), even = surfaceOf(dip);
  EXPECT_NEAR(surface.height(0, 0.003), -1e-4, roundOff);
  EXPECT_NEAR(surface.height(0, 0.009), -1e-4 * (1 - 0.25), 1e-15);
  EXPECT_NEAR(surface.height(0, -0.003), -1e-4 * (1 - 0.25), 1e-15);
  EXPECT_EQ(surface.height(0, 0.0151), 0);
  EXPECT_EQ(even.height(0, 0.02), even.height(0, 0));
}

// Points pass through; the line through the ends is the undisturbed surface, or not: then the ends stay where they are.
TEST(DefectKeys, ProfilePassesThroughItsPoints) {
  const Values tilted{{"defect.shape", "profile"},
                      {"defect.points", "[[0, 0.01], [10, -0.1], [20, 0.03]]"},
                      {"defect.height_scale", "2"}};
  const auto level = surfaceOf(tilted);
  EXPECT_NEAR(level.height(0), 2 * (-1e-4 - 2e-5), 1e-15);
  EXPECT_NEAR(level.height(-0.01), 0, 1e-15);
  Values asMeasured = tilted;
  asMeasured.push_back({"defect.level", "false"});
  const auto raw = surfaceOf(asMeasured);
  EXPECT_NEAR(raw.height(0), -2e-4, 1e-15);
  EXPECT_NEAR(raw.height(-0.01), 2e-5, 1e-15);
  EXPECT_NEAR(raw.height(0.01), 6e-5, 1e-15);
}

// Two dips in one scan: each has its stretch. The filter takes the point of 0.3 mm away; over 20 mm it also takes the
// dip of three points.
TEST(DefectKeys, AStretchAndAFilterOfMeasuredPoints) {
  Values scan{{"motion.run_up", "0.2"}, {"defect.shape", "profile"}, {"defect.points", ""}};
  std::string& points = scan.back().second;
  for (int i = 0; i <= 100; ++i) {
    const char* height = i == 20 ? "-0.1" : i == 19 || i == 21 ? "-0.05" : i == 70 ? "-0.2" : i == 85 ? "-0.3" : "0";
    const char* beside = i == 69 || i == 71 ? "-0.1" : height;
    points += (i ? ", [" : "[[") + std::to_string(2 * i) + ", " + beside + "]";
  }
  points += "]";
  const auto depthWith = [&](const Values& more) {
    Values all = scan;
    all.insert(all.end(), more.begin(), more.end());
    return surfaceOf(all).depth();
  };
  EXPECT_NEAR(depthWith({}), 3e-4, roundOff);
  EXPECT_NEAR(depthWith({{"defect.from", "0.02"}, {"defect.to", "0.06"}}), 1e-4, roundOff);
  EXPECT_NEAR(depthWith({{"defect.from", "0.12"}, {"defect.to", "0.16"}}), 2e-4, roundOff);
  EXPECT_NEAR(depthWith({{"defect.filter", "outliers"},
                         {"defect.filter_width", "8"},
                         {"defect.from", "0.16"},
                         {"defect.to", "0.18"}}),
              0, roundOff);
  EXPECT_NEAR(depthWith({{"defect.filter", "median"}, {"defect.filter_width", "20"}}), 0, roundOff);
}

TEST(DefectKeys, LinesStandSideBySide) {
  const auto surface =
      surfaceOf({{"defect.shape", "profile"},
                 {"defect.lines", "[[-10, [[0, 0], [10, -0.05], [20, 0]]], [10, [[0, 0], [10, -0.15], [20, 0]]]]"},
                 {"defect.lateral_centre", "2"}});
  EXPECT_NEAR(surface.height(0, -0.008), -5e-5, 1e-15);
  EXPECT_NEAR(surface.height(0, 0.012), -1.5e-4, 1e-15);
  EXPECT_NEAR(surface.height(0, 0.002), -1e-4, 1e-15);  // between two lines the cubic is straight
}

TEST(DefectKeys, FileHasThePoints) {
  const tests::TemporaryFolder folder;
  writeDurably(folder / "dip.csv", "position [mm],height [um]\n0,0\n10,-130\n20,0\n");
  const auto surface = surfaceOf({{"defect.shape", "profile"}, {"defect.file", folder / "dip.csv"}});
  EXPECT_NEAR(surface.depth(), 130e-6, 1e-15);
  EXPECT_NEAR(surface.last() - surface.first(), 0.02, 1e-12);
}

}  // namespace
}  // namespace squat
