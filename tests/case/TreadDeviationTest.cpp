// A tread that is not round: its curve, the path of a rigid wheel with it, and how it is read and checked.
#include "scenario/TreadDeviation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "case/ShippedCases.h"
#include "case/TreadFile.h"
#include "case/Validation.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

constexpr double treadRadius = 0.46, treadTurn = 2 * std::numbers::pi * treadRadius;

// A chord of length L cut off a circle: what is missing at the arc s from its middle.
double missing(double s, double length) {
  const double half = std::asin(0.5 * length / treadRadius), angle = s / treadRadius;
  return std::abs(angle) < half ? treadRadius * (1 - std::cos(half) / std::cos(angle)) : 0;
}

TreadShape chordFlat(double length) {
  TreadShape shape;
  for (int i = -160; i <= 160; ++i) shape.points.push_back({0.5e-3 * i, -missing(0.5e-3 * i, length)});
  return shape;
}

// A rigid wheel turns about the edge of a chord flat: its axis stands R cos(half - |turned|) high, lowest on the flat
// itself, R (1 - cos half) = L^2 / 8R. Tolerance 15 um: between points 0.5 mm apart the curve rounds the edge, at a
// slope of 0.087, by up to 0.15 of 43 um, and edges are looked for every 0.2 mm.
TEST(TreadDeviation, AChordFlatLowersARigidWheelByTheKnownFormula) {
  const double length = 0.08, half = std::asin(0.5 * length / treadRadius);
  const TreadDeviation tread(chordFlat(length), treadRadius);
  double lowest = 0;
  for (const auto& point : scenario::rigidWheelPath(DefectSurface(), tread, treadRadius, -0.08, 0.08, 0.001)) {
    const double turned = std::abs(point.position) / treadRadius;
    const double expected = turned < half ? treadRadius * (std::cos(half - turned) - 1) : 0;
    EXPECT_NEAR(point.height, expected, 15e-6) << point.position;
    lowest = std::min(lowest, point.height);
  }
  EXPECT_NEAR(lowest, -length * length / (8 * treadRadius), 15e-6);
}

// A wheel with the deviation A cos(k s) rises as on a rail with that irregularity: at long waves by the irregularity
// itself and, since it touches on the slope, by R d'(s)^2 / 2 more, up to 0.39 um here. Tolerance 0.03 um: the next
// order is A k^2 R = 0.008 of that, and steps of 0.2 mm in the search miss 0.01 um.
TEST(TreadDeviation, AWaveLiftsTheWheelAsTheSameWaveOnTheRail) {
  constexpr int order = 6;
  const double k = order / treadRadius, amplitude = 1e-4;
  TreadShape shape;
  for (int i = 0; i < 2000; ++i)
    shape.points.push_back({treadTurn * i / 2000, -amplitude * std::cos(k * treadTurn * i / 2000)});
  const TreadDeviation tread(shape, treadRadius);
  EXPECT_FALSE(tread.isLocal());
  for (const auto& point : scenario::rigidWheelPath(DefectSurface(), tread, treadRadius, -1, 1, 0.05)) {
    const double x = point.position, slope = amplitude * k * std::sin(k * x);
    EXPECT_NEAR(point.height, -amplitude * std::cos(k * x) + 0.5 * treadRadius * slope * slope, 0.03e-6) << x;
  }
}

// A flat is one place; a polygon is none, however short its waves.
TEST(TreadDeviation, AFlatIsLocalAndAPolygonIsNot) {
  EXPECT_TRUE(TreadDeviation(chordFlat(0.06), treadRadius).isLocal());
  EXPECT_TRUE(loadScenario("wheel-flat").tread.isLocal());
  TreadShape polygon;
  for (int i = 0; i < 2000; ++i)
    polygon.points.push_back({treadTurn * i / 2000, 1e-4 * std::cos(25 * 2 * std::numbers::pi * i / 2000)});
  const TreadDeviation tread(polygon, treadRadius);
  EXPECT_LT(tread.dipBefore() + tread.dipBehind(), treadTurn / 25);
  EXPECT_FALSE(tread.isLocal());
}

TEST(TreadDeviation, ComesAgainEveryTurn) {
  const TreadDeviation tread(chordFlat(0.06), treadRadius);
  const auto curve = tread.curveAt(0);
  for (const double angle : {-0.02, 0.0, 0.03, 1.0})
    for (const int turns : {-2, 1, 40})
      // 40 turns: an angle of 250 rad is known to 3e-14 rad; slope 0.09 times 0.46 m
      EXPECT_NEAR(curve.at(angle + 2 * std::numbers::pi * turns).height, curve.at(angle).height, 1e-14);
}

// Goes through its points wherever the table begins, its slope is that of its heights, and it stays between them.
TEST(TreadDeviation, TheCurveIsContinuousAllRound) {
  TreadShape shape;
  for (int i = 0; i < 36; ++i) shape.points.push_back({treadTurn * (i + 7) / 36, 1e-4 * std::sin(i * 1.7)});
  const TreadDeviation tread(shape, treadRadius);
  const auto curve = tread.curveAt(0);
  double deepest = 0;
  for (const auto& point : shape.points) deepest = std::min(deepest, point.height);
  EXPECT_DOUBLE_EQ(curve.at(0).height, deepest);
  EXPECT_DOUBLE_EQ(tread.lowest(), deepest);
  constexpr double step = 1e-6;  // [rad]
  for (double angle = -4; angle < 4; angle += 0.013) {
    const double change = (curve.at(angle + step).height - curve.at(angle - step).height) / (2 * step);
    EXPECT_NEAR(curve.at(angle).slope, change, 5e-8) << angle;  // curvature of up to 0.05 m/rad2 times the step
    EXPECT_LE(curve.at(angle).height, tread.highest() + 1e-18);
    EXPECT_GE(curve.at(angle).height, tread.lowest() - 1e-18);
  }
}

TEST(TreadDeviation, IsRoundWhereTheTableEnds) {
  TreadShape shape;
  shape.points = {{0, 2e-5}, {0.03, -1e-3}, {0.06, 0}};
  const auto curve = TreadDeviation(shape, treadRadius).curveAt(0);
  EXPECT_EQ(curve.at(0.031 / treadRadius).height, 0);
  EXPECT_EQ(curve.at(std::numbers::pi).height, 0);
  EXPECT_NEAR(curve.at(-0.03 / treadRadius).height, 2e-5, 1e-15);
  EXPECT_EQ(curve.at(-0.0501 / treadRadius).height, 0);  // runs out over 20 mm
}

TEST(TreadDeviation, LinesSideBySide) {
  TreadShape shape;
  shape.lines = {{-0.01, {{0, 0}, {0.02, -1e-3}, {0.04, 0}}}, {0.01, {{0, 0}, {0.02, -4e-4}, {0.04, 0}}}};
  const TreadDeviation tread(shape, treadRadius);
  EXPECT_DOUBLE_EQ(tread.curveAt(-0.01).at(0).height, -1e-3);
  EXPECT_DOUBLE_EQ(tread.curveAt(0.02).at(0).height, -4e-4);  // beyond: as the outermost
  EXPECT_NEAR(tread.curveAt(0).at(0).height, -7e-4, 1e-9);    // half way between two level ends
  EXPECT_DOUBLE_EQ(tread.lowest(), -1e-3);
}

// CONTACT's static answer for the scanned flat (program CONTACT, example wheelflat): how far the wheelset comes down as
// it turns over the flat, 13 positions 2 degrees apart. Elastic deflection changes it by some 0.03 mm. Tolerance 0.07
// mm: CONTACT has the whole scan, and the wheel stands 8 mm off the middle of the rail; a rigid wheel with the scanned
// profile there agrees with CONTACT to 0.013 mm, the tape circle alone to 0.064 mm.
// In the middle of the flat (pitch -0.6458) the tape circle cannot do it: the wheel stands on the outer edge of the
// flat, which is 35 mm wide, 20 mm beside the tape circle, and comes down by 0.71 mm. A wheel with this flat all across
// its tread stands on its ends, at -18 mm, and comes down by 1.23 mm, d - x^2 / 2R of the file by hand.
TEST(TreadDeviation, TheScannedFlatLowersTheWheelAsContactSays) {
  struct Position {
    double pitch, lowering;  // [rad], [mm] relative to the round part
  };
  const Position positions[] = {{-0.4363, 0.0000}, {-0.4712, 0.0000}, {-0.5061, 0.0128}, {-0.5411, 0.0641},
                                {-0.5760, 0.2144}, {-0.6109, 0.5402}, {-0.6807, 0.5975}, {-0.7156, 0.2594},
                                {-0.7505, 0.0960}, {-0.7854, 0.0322}, {-0.8203, 0.0030}, {-0.8552, 0.0002}};
  const auto scenario = loadScenario("wheel-flat");
  constexpr double scanned = 0.49, deepest = 0.31801;  // [m] radius, arc of the deepest point in the file
  const auto loweringAt = [&](double pitch) {
    const double x = -pitch * scanned - deepest;
    const auto path = scenario::rigidWheelPath(DefectSurface(), scenario.tread, scanned, x, x, 1);
    return 0.024 - 1e3 * path.front().height;
  };
  for (const auto& [pitch, lowering] : positions) EXPECT_NEAR(loweringAt(pitch), lowering, 0.07) << pitch;
  EXPECT_NEAR(loweringAt(-0.6458), 1.227, 0.02);  // points of the file 1 mm apart, slope 0.04, rough by 0.01 mm
}

using TreadSettings = std::vector<std::pair<std::string, std::string>>;

std::vector<CaseProblem> warningsOf(const TreadSettings& settings) {
  return validate(loadCase(tests::fixtureCase("smooth-rail"), {"draft", settings})).warnings;
}

MATCHER_P2(Says, key, words, "") { return arg.key == key && arg.advice.find(words) != std::string::npos; }

TEST(TreadFile, ReadsArcAngleAndLines) {
  const auto arc = parseTreadLines("arc_length_mm,radial_deviation_mm\n0,0\n10,-0.5\n20,0\n", "x", treadRadius);
  ASSERT_EQ(arc.size(), 1u);
  EXPECT_DOUBLE_EQ(arc[0].points[1].position, 0.010);
  EXPECT_DOUBLE_EQ(arc[0].points[1].height, -0.5e-3);
  for (const char* heading : {"angle [deg]; deviation [mm]", "angle_deg; deviation_mm", "angle (°); deviation (mm)"}) {
    const auto lines = parseTreadLines(std::string(heading) + "\n-1; 0\n0; -0.5\n1; 0\n", "x", treadRadius);
    EXPECT_DOUBLE_EQ(lines[0].points[2].position, std::numbers::pi / 180 * treadRadius) << heading;
  }
  for (const char* above : {"Axle 3, left wheel\n\nangle [deg]; deviation [mm]", "angle; deviation\ndeg; mm",
                            "# 5 deg; remark\nangle [deg]; deviation [mm]", "angle; deviation\n[\xC2\xB0]; [mm]"}) {
    const auto scanned = parseTreadLines(std::string(above) + "\n-1; 0\n0; -0.5\n1; 0\n", "x", treadRadius);
    EXPECT_DOUBLE_EQ(scanned[0].points[2].position, std::numbers::pi / 180 * treadRadius) << above;
    EXPECT_DOUBLE_EQ(scanned[0].points[1].height, -0.5e-3) << above;
  }
  const auto lines =
      parseTreadLines("angle [rad]; y = -10 mm [um]; y = 10 mm [um]\n0; 0; 0\n0.1; -100; -50\n", "x", treadRadius);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_DOUBLE_EQ(lines[1].lateral, 0.010);
  EXPECT_DOUBLE_EQ(lines[1].points[1].position, 0.1 * treadRadius);
  EXPECT_DOUBLE_EQ(lines[1].points[1].height, -50e-6);
  EXPECT_THROW(parseTreadLines("angle [deg]; deviation\n0; 0\n1; 0\n", "x", treadRadius), FileError);
}

TEST(TreadFile, IsReadIntoTheCaseAndStaysThere) {
  const auto read = loadCase("wheel-flat");
  EXPECT_GT(read.tread.points.size(), 250u);
  const auto again = parseCase(writeCase(read), "again", "/nowhere");
  EXPECT_EQ(writeCase(again), writeCase(read));
  EXPECT_EQ(caseHash(again), caseHash(read));
  // What a result carries opens no file.
  EXPECT_EQ(parseCaseOfResult(writeCase(read), "result").tread.points.size(), read.tread.points.size());
  EXPECT_THAT(filesOfCase("wheel-flat", read), testing::Contains(testing::HasSubstr("treads/wheel-flat.csv")));
  EXPECT_THROW(loadCase("smooth-rail", {"", {{"wheelset.tread_deviation", "none.csv"}}}), FileError);
}

// What was computed before there were treads keeps its hash; where the flat lies counts, which file it is from not.
TEST(TreadFile, CountsInTheHashByItsPoints) {
  auto round = loadCase("smooth-rail");
  const auto hash = caseHash(round);
  round.tread.file = "elsewhere.csv";
  EXPECT_EQ(caseHash(round), hash);
  auto flat = round;
  setValue(flat, "wheelset.tread_points", "[[0, 0], [20, -1], [40, 0]]");
  EXPECT_NE(caseHash(flat), hash);
  auto moved = flat;
  setValue(moved, "wheelset.tread_position", "0.1");
  EXPECT_NE(caseHash(moved), caseHash(flat));
}

TEST(TreadValidation, SaysWhatIsWrong) {
  const auto problems = [](const TreadSettings& settings) {
    try {
      loadCase(tests::fixtureCase("smooth-rail"), {"draft", settings});
    } catch (const CaseError& error) {
      return error.problems();
    }
    return std::vector<CaseProblem>{};
  };
  const char* table = "wheelset.tread_points";
  EXPECT_THAT(problems({{table, "[[0, 0], [1000, -0.1], [3000, 0]]"}}),
              testing::Contains(Says(table, "more than the circumference")));
  EXPECT_THAT(problems({{table, "[[0, 0], [30, -20], [60, 0]]"}}), testing::Contains(Says(table, "not the radius")));
  EXPECT_THAT(problems({{table, "[[0, 0], [1, -1], [2, 0]]"}}), testing::Contains(Says(table, "too steep")));
  const auto cosine = [](double length, double depth) {  // [mm], 20 points
    std::string points;
    for (int i = 0; i <= 20; ++i)
      points += (points.empty() ? "[[" : ", [") + std::to_string(length * i / 20) + ", " +
                std::to_string(-0.5 * depth * (1 - std::cos(2 * std::numbers::pi * i / 20))) + "]";
    return points + "]";
  };
  const std::string flat = cosine(40, 0.9);
  EXPECT_THAT(warningsOf({{table, flat}}), testing::Not(testing::Contains(Says(table, ""))));
  EXPECT_THAT(warningsOf({{table, flat}, {"wheelset.tread_position", "5"}}),
              testing::Contains(Says("wheelset.tread_position", "does not meet the rail")));
  EXPECT_THAT(warningsOf({{table, flat}, {"wheelset.tread_position", "-0.39"}, {"motion.run_up", "0.4"}}),
              testing::Contains(Says("wheelset.tread_position", "stands on the flat")));
  EXPECT_THAT(warningsOf({{table, cosine(8, 0.05)}}), testing::Contains(Says("mesh.contact_size", "too coarse")));
  EXPECT_THAT(warningsOf({{table, "[[0, 0.1], [20, -0.9], [40, 0]]"}}), testing::Contains(Says(table, "runs out")));
  EXPECT_THAT(warningsOf({{table, "[[0, 0], [20, -0.9], [40, 0]]"}}), testing::Contains(Says(table, "interpolated")));
}

}  // namespace
}  // namespace squat::cases
