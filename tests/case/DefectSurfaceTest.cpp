// Shapes of defects against their formulas; sampled profiles against SciPy's monotone cubic (data/monotone_cubic.py).
#include "case/CaseDescription.h"
#include "scenario/DefectSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "case/ParameterTable.h"

namespace squat::cases {
namespace {

constexpr double pi = std::numbers::pi;
// Heights are of the order of 1e-4 m; a few units in the last place of the terms they are made of.
constexpr double roundOff = 1e-18;

Defect defectOf(DefectShape shape) {
  Defect defect = defaultCase().defect;
  defect.shape = shape;
  defect.length = 0.050;
  defect.depth = 0.00015;
  defect.ramp = 0.004;
  defect.waveLength = 0.027;
  defect.waveDepth = 0.00005;
  defect.waveCount = 2;
  defect.middleHeight = 0.4;
  return defect;
}

Defect profileOf(std::vector<ProfilePoint> points, bool level = true) {
  Defect defect = defectOf(DefectShape::profile);
  defect.points = std::move(points);
  defect.level = level;
  return defect;
}

// The slope must be the derivative of the height: central difference over 1e-6 m; its error is h^2/6 times the third
// derivative, below 2e-7 for these shapes, plus 1e-19/1e-6 of round-off.
void expectSlopesFit(const DefectSurface& surface, const std::vector<double>& kinks = {}) {
  constexpr double h = 1e-6;
  for (double x = surface.first() - 0.01; x < surface.last() + 0.01; x += 0.000317) {
    bool near = false;
    for (const double kink : kinks) near = near || std::abs(x - kink) < 2 * h;
    if (near) continue;
    EXPECT_NEAR(surface.slope(x), (surface.height(x + h) - surface.height(x - h)) / (2 * h), 1e-6) << "x = " << x;
  }
}

TEST(DefectSurface, SmoothRailIsZeroEverywhere) {
  const DefectSurface surface(defectOf(DefectShape::none));
  for (double x = -0.1; x < 0.1; x += 0.01) EXPECT_EQ(surface.height(x), 0);
  EXPECT_EQ(surface.first(), 0);
  EXPECT_EQ(surface.last(), 0);
  EXPECT_TRUE(surface.samples().empty());
}

TEST(DefectSurface, CutHasRampsAndFlatFloor) {
  const DefectSurface surface(defectOf(DefectShape::cut));
  for (const double x : {0.0, 0.01, -0.02, 0.0209}) EXPECT_DOUBLE_EQ(surface.height(x), -0.00015) << x;
  EXPECT_NEAR(surface.height(0.023), -0.000075, roundOff);  // middle of the ramp from 21 to 25 mm
  EXPECT_NEAR(surface.height(-0.024), -0.0000375, roundOff);
  EXPECT_EQ(surface.height(0.025), 0);
  EXPECT_EQ(surface.height(-0.026), 0);
  EXPECT_DOUBLE_EQ(surface.slope(0.022), 0.00015 / 0.004);
  EXPECT_DOUBLE_EQ(surface.slope(-0.022), -0.00015 / 0.004);
  EXPECT_DOUBLE_EQ(surface.steepest(), 0.00015 / 0.004);
  EXPECT_DOUBLE_EQ(surface.depth(), 0.00015);
  EXPECT_DOUBLE_EQ(surface.first(), -0.025);
  expectSlopesFit(surface, {-0.025, -0.021, 0.021, 0.025});
}

TEST(DefectSurface, CosineFollowsItsFormula) {
  const DefectSurface surface(defectOf(DefectShape::cosine));
  for (double x = -0.025; x < 0.025; x += 0.0007)
    EXPECT_NEAR(surface.height(x), -0.000075 * (1 + std::cos(2 * pi * x / 0.05)), roundOff);
  EXPECT_DOUBLE_EQ(surface.height(0), -0.00015);
  EXPECT_EQ(surface.height(0.0251), 0);
  // steepest at a quarter: depth pi / length; the samples of the search miss it by less than 1e-6 of it
  EXPECT_NEAR(surface.steepest(), 0.00015 * pi / 0.05, 1e-6 * 0.01);
  // 5 % of the depth: (1 + cos) / 2 = 0.05
  EXPECT_NEAR(surface.dipLength(), 2 * 0.05 / (2 * pi) * std::acos(-0.9), 1e-12);
  expectSlopesFit(surface);
}

TEST(DefectSurface, WShapeHasTwoBottomsAndARidge) {
  const DefectSurface surface(defectOf(DefectShape::wshape));
  EXPECT_DOUBLE_EQ(surface.first(), -0.0125);
  EXPECT_DOUBLE_EQ(surface.last(), 0.0375);
  EXPECT_DOUBLE_EQ(surface.height(0), -0.00015);
  EXPECT_NEAR(surface.height(0.0125), -0.00015 * 0.6, roundOff);
  EXPECT_NEAR(surface.height(0.025), -0.00015, roundOff);
  EXPECT_NEAR(surface.height(-0.00625), -0.000075, roundOff);      // half way down
  EXPECT_NEAR(surface.height(0.00625), -0.00015 * 0.8, roundOff);  // half way up to the ridge
  EXPECT_NEAR(surface.height(0.0125 - 0.004), surface.height(0.0125 + 0.004), roundOff);
  EXPECT_EQ(surface.height(-0.0126), 0);
  EXPECT_EQ(surface.height(0.0376), 0);
  expectSlopesFit(surface);
}

TEST(DefectSurface, WavesFollowTheDip) {
  const DefectSurface surface(defectOf(DefectShape::dipWithWave));
  EXPECT_DOUBLE_EQ(surface.height(0), -0.00015);
  EXPECT_NEAR(surface.height(0.025), 0, roundOff);
  EXPECT_NEAR(surface.height(0.025 + 0.0135), -0.00005, roundOff);
  EXPECT_NEAR(surface.height(0.025 + 0.027), 0, roundOff);
  EXPECT_NEAR(surface.height(0.025 + 0.027 + 0.0135), -0.00005, roundOff);
  EXPECT_DOUBLE_EQ(surface.last(), 0.025 + 2 * 0.027);
  EXPECT_EQ(surface.height(0.0791), 0);
  expectSlopesFit(surface);
}

TEST(DefectSurface, ParabolicFadesAcross) {
  Defect defect = defectOf(DefectShape::cosine);
  defect.lateral = LateralShape::parabolic;
  defect.halfWidth = 0.02;
  const DefectSurface surface(defect);
  EXPECT_DOUBLE_EQ(surface.height(0, 0), -0.00015);
  EXPECT_DOUBLE_EQ(surface.height(0, 0.01), -0.00015 * 0.75);
  EXPECT_DOUBLE_EQ(surface.height(0, -0.01), -0.00015 * 0.75);
  EXPECT_EQ(surface.height(0, 0.02), 0);
  EXPECT_EQ(surface.height(0, -0.03), 0);
  defect.lateral = LateralShape::uniform;
  EXPECT_DOUBLE_EQ(DefectSurface(defect).height(0, 0.03), -0.00015);
}

TEST(DefectSurface, ProfileGoesThroughItsPoints) {
  const DefectSurface surface(profileOf({{2, 0}, {2.005, -1e-4}, {2.012, -2e-4}, {2.02, -3e-5}, {2.03, 0}}));
  EXPECT_DOUBLE_EQ(surface.height(0), -2e-4);
  EXPECT_NEAR(surface.height(-0.007), -1e-4, 1e-15);  // positions of 2 m leave 4e-16 m of round-off, times the slope
  EXPECT_NEAR(surface.height(0.008), -3e-5, 1e-15);
  EXPECT_NEAR(surface.first(), -0.012, 1e-15);
  EXPECT_NEAR(surface.last(), 0.018, 1e-15);
  EXPECT_EQ(surface.height(-0.013), 0);
  EXPECT_EQ(surface.height(0.019), 0);
  EXPECT_NEAR(surface.profileSpacing(), 0.010, 1e-15);
  expectSlopesFit(surface);
}

TEST(DefectSurface, ProfileIsMonotoneBetweenPoints) {
  const std::vector<ProfilePoint> points{{0, 0},        {0.005, -1e-5}, {0.006, -2e-4},
                                         {0.02, -2e-4}, {0.021, -1e-5}, {0.03, 0}};
  const DefectSurface surface(profileOf(points));
  const auto shifted = surface.samples();
  for (std::size_t i = 0; i + 1 < shifted.size(); ++i) {
    const double low = std::min(shifted[i].height, shifted[i + 1].height) - roundOff;
    const double high = std::max(shifted[i].height, shifted[i + 1].height) + roundOff;
    for (int k = 0; k <= 50; ++k) {
      const double x = shifted[i].position + (shifted[i + 1].position - shifted[i].position) * k / 50;
      EXPECT_GE(surface.height(x), low) << x;
      EXPECT_LE(surface.height(x), high) << x;
    }
  }
  EXPECT_DOUBLE_EQ(surface.depth(), 2e-4);
}

TEST(DefectSurface, ProfileIsSciPysMonotoneCubic) {
  const DefectSurface surface(profileOf({{-0.040, 0},
                                         {-0.035, 0},
                                         {-0.028, -12e-6},
                                         {-0.020, -30e-6},
                                         {-0.011, -30e-6},
                                         {-0.006, -95e-6},
                                         {0, -150e-6},
                                         {0.004, -120e-6},
                                         {0.009, -130e-6},
                                         {0.015, -60e-6},
                                         {0.022, -5e-6},
                                         {0.030, -9e-6},
                                         {0.035, 0},
                                         {0.040, 0}}));
  std::ifstream file(std::string(SQUAT_SOURCE_DIR) + "/tests/case/data/monotone_cubic.csv");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  int count = 0;
  while (std::getline(file, line)) {
    double x = 0, height = 0, slope = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &x, &height, &slope), 3) << line;
    // 15 digits in the file; heights of 1e-4 m and slopes of 1e-2
    EXPECT_NEAR(surface.height(x * 1e-3), height * 1e-6, 1e-17) << "x = " << x;
    EXPECT_NEAR(surface.slope(x * 1e-3), slope * 1e-3, 1e-14) << "x = " << x;
    ++count;
  }
  EXPECT_GT(count, 90);
}

TEST(DefectSurface, LevelTakesOffTheLineThroughTheEnds) {
  std::vector<ProfilePoint> tilted{{0, 1e-4}, {0.01, 1e-4}, {0.02, -1e-4}, {0.03, 1e-4}, {0.04, 1e-4}};
  for (auto& point : tilted) point.height += 3e-3 * point.position;
  const DefectSurface surface(profileOf(tilted));
  EXPECT_NEAR(surface.height(0), -2e-4, 1e-18);
  EXPECT_NEAR(surface.height(0.0099), 0, 1e-7);  // 0.1 mm before the next point
  EXPECT_NEAR(surface.depth(), 2e-4, 1e-18);
  EXPECT_EQ(surface.height(0.021), 0);
}

TEST(DefectSurface, WithoutLevelTheEndsRunOut) {
  const DefectSurface surface(profileOf({{0, 2e-5}, {0.01, -1e-4}, {0.02, 4e-5}}, false));
  EXPECT_DOUBLE_EQ(surface.height(0), -1e-4);
  EXPECT_NEAR(surface.height(0.01), 4e-5, 1e-17);
  EXPECT_NEAR(surface.last(), 0.03, 1e-17);
  EXPECT_NEAR(surface.first(), -0.03, 1e-17);
  EXPECT_EQ(surface.height(0.0301), 0);
  expectSlopesFit(surface);
}

TEST(DefectSurface, ScaleActsOnProfiles) {
  Defect defect = profileOf({{0, 0}, {0.01, -1e-4}, {0.02, 0}});
  defect.heightScale = 1.5;
  EXPECT_DOUBLE_EQ(DefectSurface(defect).depth(), 1.5e-4);
  defect.heightScale = 0;
  EXPECT_EQ(DefectSurface(defect).depth(), 0);
}

// The same dip with a long plane rail before and behind it: 100,000 points, the most that a profile may have.
TEST(DefectSurface, LongPlaneEndsAreTrimmed) {
  std::vector<ProfilePoint> points;
  for (int i = 0; i < 100000; ++i) points.push_back({i * 0.001, i > 50000 && i < 50020 ? -1e-4 : 0});
  const DefectSurface surface(profileOf(points));
  EXPECT_NEAR(surface.first(), -0.001, 1e-12);  // round-off of positions of 50 m
  EXPECT_NEAR(surface.last(), 0.019, 1e-12);
  EXPECT_NEAR(surface.profileSpacing(), 0.001, 1e-12);
  EXPECT_EQ(surface.samples().size(), 21u);
}

// A short step in a long profile must not be missed: 0.1 mm over 1 mm, cubic with level ends: 1.5 times the secant.
TEST(DefectSurface, FindsTheSteepestPlaceOfALongProfile) {
  const DefectSurface surface(profileOf({{0, 0}, {10, -1e-5}, {20, -1e-5}, {20.001, -1.1e-4}, {30, -1.1e-4}, {50, 0}}));
  EXPECT_NEAR(surface.steepest(), 0.15, 1e-9);
}

TEST(DefectSurface, OddProfilesAreNoDefect) {
  EXPECT_EQ(DefectSurface(profileOf({})).last(), 0);
  EXPECT_EQ(DefectSurface(profileOf({{1, -1}})).last(), 0);
  EXPECT_EQ(DefectSurface(profileOf({{0, 0}, {1, 0}, {2, 0}})).last(), 0);
}

TEST(DefectSurface, FreeFunctionGivesTheSame) {
  const Defect defect = defectOf(DefectShape::cosine);
  EXPECT_EQ(defectHeight(defect, 0.01, 0.003), DefectSurface(defect).height(0.01, 0.003));
}

// A wheel over a cut with steep ramps touches both edges: it drops L^2/(8 R) at most (chord of length L), here
// 0.02^2/(8*0.46) = 0.1087 mm for 20 mm; less where the floor is higher. Ramps of 0.1 mm shift the edges by a part of
// that: 2 * 0.1 / 20 of the length, so 2 % of the drop; the search steps by 0.2 mm.
TEST(RigidWheelPath, WheelDropsIntoACutByItsGeometry) {
  Defect defect = defectOf(DefectShape::cut);
  defect.length = 0.02;
  defect.depth = 0.0005;
  defect.ramp = 0.0001;
  const auto path = rigidWheelPath(DefectSurface(defect), 0.46, -0.03, 0.03, 0.0005);
  ASSERT_EQ(path.size(), 121u);
  double lowest = 0;
  for (const auto& point : path) lowest = std::min(lowest, point.height);
  EXPECT_NEAR(lowest, -0.02 * 0.02 / (8 * 0.46), 0.02 * 1.087e-4);
  EXPECT_DOUBLE_EQ(path.front().position, -0.03);
  EXPECT_NEAR(path.back().position, 0.03, 1e-15);
  EXPECT_EQ(path.front().height, 0);
}

// A dip flatter than the wheel (curvature below 1/R) is followed: curvature 2 pi^2 depth / L^2 = 0.74 / m at its
// bottom.
TEST(RigidWheelPath, WheelReachesTheFloorOfALongDip) {
  Defect defect = defectOf(DefectShape::cosine);
  defect.length = 0.2;
  defect.depth = 0.0015;
  const DefectSurface surface(defect);
  const auto path = rigidWheelPath(surface, 0.46, -0.15, 0.15, 0.01);
  EXPECT_NEAR(path[15].height, -0.0015, 1e-12);
  for (const auto& point : path) EXPECT_GE(point.height, surface.height(point.position) - roundOff);
}

TEST(RigidWheelPath, SmoothRailGivesAPlanePath) {
  for (const auto& point : rigidWheelPath(DefectSurface(defectOf(DefectShape::none)), 0.46, -0.1, 0.1, 0.01))
    EXPECT_EQ(point.height, 0);
  EXPECT_TRUE(rigidWheelPath(DefectSurface(defectOf(DefectShape::cosine)), 0.46, 0, 1, 0).empty());
}

// Several lines: on each line its own profile, in between the monotone cubic across, beyond the outermost as they are;
// the deepest point of all stands at x = 0.
TEST(DefectSurface, LinesSideBySide) {
  const std::vector<ProfilePoint> shallow{{1.00, 0}, {1.01, -2e-5}, {1.02, -6e-5}, {1.03, -1e-5}, {1.04, 0}};
  const std::vector<ProfilePoint> deep{{1.01, 0}, {1.02, -1e-4}, {1.03, -3e-4}, {1.04, -1e-4}, {1.05, 0}};
  Defect defect = defectOf(DefectShape::profile);
  defect.lines = {{-0.010, shallow}, {0.0, deep}, {0.012, shallow}};
  const DefectSurface surface(defect), alone(profileOf(deep)), other(profileOf(shallow));
  EXPECT_EQ(surface.depth(), 3e-4);
  EXPECT_EQ(surface.deepestLateral(), 0);
  EXPECT_NEAR(surface.first(), -0.03, 1e-12);
  EXPECT_NEAR(surface.last(), 0.02, 1e-12);
  for (double x = -0.035; x < 0.025; x += 0.0007) {
    EXPECT_NEAR(surface.height(x, 0), alone.height(x), roundOff) << x;
    const double shifted = x + 0.01;  // the shallow line's own deepest point stands 10 mm before
    EXPECT_NEAR(surface.height(x, -0.010), other.height(shifted), 1e-15) << x;
    EXPECT_NEAR(surface.height(x, 0.012), other.height(shifted), 1e-15) << x;
    EXPECT_EQ(surface.height(x, -0.02), surface.height(x, -0.010));
    EXPECT_EQ(surface.height(x, 0.02), surface.height(x, 0.012));
    const double a = surface.height(x, 0), b = surface.height(x, 0.012), between = surface.height(x, 0.005);
    EXPECT_GE(between, std::min(a, b) - roundOff);
    EXPECT_LE(between, std::max(a, b) + roundOff);
  }
  // Halfway between two lines whose slopes across are zero there: 3 t^2 - 2 t^3 at t = 1/2 is their mean.
  EXPECT_NEAR(surface.height(0, 0.006), 0.5 * (surface.height(0, 0) + surface.height(0, 0.012)), roundOff);
  defect.heightScale = 2;
  EXPECT_EQ(DefectSurface(defect).depth(), 6e-4);
}

// Equal lines are a uniform defect, and a shift moves it sideways.
TEST(DefectSurface, EqualLinesAreUniformAndShiftsMoveThem) {
  const std::vector<ProfilePoint> dip{{0, 0}, {0.01, -1e-4}, {0.02, 0}};
  Defect defect = defectOf(DefectShape::profile);
  defect.lines = {{-0.005, dip}, {0.005, dip}};
  const DefectSurface surface(defect), one(profileOf(dip));
  for (const double y : {-0.02, -0.005, 0.0, 0.003, 0.01})
    for (double x = -0.012; x < 0.012; x += 0.0005) EXPECT_NEAR(surface.height(x, y), one.height(x), roundOff);
  Defect parabolic = defectOf(DefectShape::cosine);
  parabolic.lateral = LateralShape::parabolic;
  parabolic.halfWidth = 0.010, parabolic.lateralCentre = 0.004;
  const DefectSurface moved(parabolic);
  EXPECT_DOUBLE_EQ(moved.height(0, 0.004), -parabolic.depth);
  EXPECT_DOUBLE_EQ(moved.height(0, 0.009), -0.75 * parabolic.depth);
  EXPECT_EQ(moved.height(0, -0.0061), 0);
  EXPECT_EQ(moved.depth(), parabolic.depth);
}

}  // namespace
}  // namespace squat::cases
