// A wheel that is not round: what is read is what the contact rolls with.
#include <gtest/gtest.h>

#include <cmath>

#include "core/DurableFile.h"
#include "keys/Keys.h"
#include "results/SampleResult.h"

namespace squat {
namespace {

using tests::modelWith;
using tests::scenarioWith;

constexpr const char* points = "[[0, 0], [10, -0.3], [20, -0.5], [30, -0.2], [40, 0]]";

TEST(TreadKeys, PointsAreMillimetresAlongTheTread) {
  const auto s = scenarioWith({{"wheelset.tread_points", points}});
  const auto curve = s.tread.curveAt(0);
  const double radius = s.wheelset.radius;
  EXPECT_NEAR(curve.at(0).height, -0.5e-3, 1e-18);
  EXPECT_NEAR(curve.at(-0.010 / radius).height, -0.3e-3, 1e-17);
  EXPECT_NEAR(curve.at(0.010 / radius).height, -0.2e-3, 1e-17);
  EXPECT_TRUE(scenarioWith({}).tread.isRound());
  EXPECT_TRUE(modelWith({}).surfaces.treadCurve.empty());
}

TEST(TreadKeys, TheFileIsRead) {
  const tests::TemporaryFolder folder;
  writeDurably(folder / "tread.csv", "angle [deg]; deviation [mm]\n-2; 0\n0; -0.4\n2; 0\n");
  const auto s = scenarioWith({{"wheelset.tread_deviation", folder / "tread.csv"}});
  EXPECT_NEAR(s.tread.curveAt(0).at(0).height, -0.4e-3, 1e-18);
  EXPECT_EQ(s.tread.curveAt(0).at(2.01 / 180 * std::acos(-1.0)).height, 0);
}

TEST(TreadKeys, LinesStandSideBySide) {
  const auto s = scenarioWith(
      {{"wheelset.tread_lines", "[[-10, [[0, 0], [20, -0.2], [40, 0]]], [10, [[0, 0], [20, -0.6], [40, 0]]]]"}});
  EXPECT_NEAR(s.tread.curveAt(-0.010).at(0).height, -0.2e-3, 1e-18);
  EXPECT_NEAR(s.tread.curveAt(0.010).at(0).height, -0.6e-3, 1e-18);
  EXPECT_NEAR(s.tread.curveAt(0.030).at(0).height, -0.6e-3, 1e-18);
}

// A wheel that rolls freely from the start to that position has turned until its deepest point is below the axis.
TEST(TreadKeys, ThePositionIsWhereTheDeepestPointMeetsTheRail) {
  for (const double position : {-0.1, 0.0, 0.2}) {
    const auto model =
        modelWith({{"wheelset.tread_points", points}, {"wheelset.tread_position", std::to_string(position)}});
    const auto& s = model.surfaces;
    const double rotation = (position - model.startX) / s.radius;
    EXPECT_NEAR(rotation + s.treadAhead, 0, 1e-12);
  }
}

// The mesh is fine where the flat meets the rail.
TEST(TreadKeys, TheFlatLiesInTheFineZone) {
  const auto zone = [](const tests::Values& values) {
    const auto s = scenarioWith(values);
    return scenario::defectZone(s.defectSurface, s.tread, s.mesh);
  };
  EXPECT_EQ(zone({}).before, 0);
  const auto flat = zone({{"wheelset.tread_points", points}, {"wheelset.tread_position", "0.05"}});
  EXPECT_GT(flat.behind, 0.05 + 0.015);
  EXPECT_LT(flat.behind, 0.05 + 0.025);
  EXPECT_EQ(flat.before, 0);
}

}  // namespace
}  // namespace squat
