// Tools for plane meshes: integrals, quality measures, transfinite blocks, gradings.
#include "geometry/SectionMesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::geometry {
namespace {

TEST(SectionMesh, IntegralsOfATrapezoid) {
  // Trapezoid with parallel sides a = 3, b = 1, height 2, symmetric: area 4, centroid h (a + 2b) / 3(a + b) = 5/6 above
  // the long side, I = h^3 (a^2 + 4ab + b^2) / 36 (a + b) = 11/9; about the axis of symmetry
  // h (a^4 - b^4) / 48 (a - b) = 5/3.
  SectionMesh mesh;
  mesh.nodes = {{-1.5, 10}, {1.5, 10}, {0.5, 12}, {-0.5, 12}};
  mesh.quads = {{0, 1, 2, 3}};
  const auto integrals = sectionIntegrals(mesh);
  EXPECT_NEAR(integrals.area, 4, 1e-12);
  EXPECT_NEAR(integrals.centroidB, 0, 1e-12);
  EXPECT_NEAR(integrals.centroidC, 10 + 5.0 / 6, 1e-12);
  EXPECT_NEAR(integrals.momentCC, 11.0 / 9, 1e-12);
  EXPECT_NEAR(integrals.momentBB, 5.0 / 3, 1e-11);
}

TEST(SectionMesh, QualityOfKnownQuads) {
  SectionMesh mesh;
  mesh.nodes = {{0, 0}, {4, 0}, {4, 1}, {0, 1}, {5, 1}, {1, 1}, {0.5, 0.1}};
  mesh.quads = {{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 6, 3}};
  EXPECT_NEAR(scaledJacobian(mesh, 0), 1, 1e-15);
  EXPECT_NEAR(aspectRatio(mesh, 0), 4, 1e-15);
  EXPECT_NEAR(scaledJacobian(mesh, 1), std::sqrt(0.5), 1e-12);  // parallelogram of 45 degrees
  EXPECT_LT(scaledJacobian(mesh, 2), 0);                        // a corner bent inwards
}

TEST(SectionMesh, BlockFollowsItsEdgesAndMerges) {
  // A quarter of an annulus beside a square: shared edge nodes are merged, quads turn counter-clockwise.
  BlockMesher mesher(1e-7);
  std::vector<Point2> inner, outer, start, stop;
  for (int i = 0; i <= 6; ++i) {
    const double angle = std::acos(0.0) * (1 - i / 6.0);
    inner.push_back({std::cos(angle), std::sin(angle)}), outer.push_back({2 * std::cos(angle), 2 * std::sin(angle)});
  }
  for (int i = 0; i <= 3; ++i) start.push_back({0, 1 + i / 3.0}), stop.push_back({1 + i / 3.0, 0});
  mesher.addBlock(inner, outer, start, stop);
  mesher.addBlock({stop[0], stop[1], stop[2], stop[3]},
                  {{1, -1}, {1.3333333333333333, -1}, {1.6666666666666667, -1}, {2, -1}}, {stop[0], {1, -1}},
                  {stop[3], {2, -1}});
  const auto mesh = mesher.take();
  EXPECT_EQ(mesh.nodes.size(), 7u * 4 + 4);
  ASSERT_EQ(mesh.quads.size(), 6u * 3 + 3);
  for (int q = 0; q < 18; ++q) EXPECT_GT(scaledJacobian(mesh, q), 0.95);  // (r, angle) grid: right angles
  for (const auto& p : mesh.nodes)
    if (p[1] > 0) {
      // Rings of the transfinite block are circles with the edges' radii.
      const double r = std::hypot(p[0], p[1]) * 3;
      EXPECT_NEAR(r, std::round(r), 1e-9);
    }
}

TEST(SectionMesh, MirrorKeepsTheTurningSense) {
  BlockMesher mesher(1e-9);
  mesher.addBlock({{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}, {{1, 0}, {1, 1}});
  mesher.mirror();
  const auto mesh = mesher.take();
  EXPECT_EQ(mesh.nodes.size(), 6u);
  ASSERT_EQ(mesh.quads.size(), 2u);
  EXPECT_NEAR(scaledJacobian(mesh, 1), 1, 1e-15);
  EXPECT_NEAR(sectionIntegrals(mesh).area, 2, 1e-15);
}

TEST(SectionMesh, GradingsGrowByAConstantFactor) {
  const auto s = gradedSpacing(7, 0.05);
  ASSERT_EQ(s.size(), 8u);
  EXPECT_EQ(s.front(), 0);
  EXPECT_EQ(s.back(), 1);
  EXPECT_NEAR(s[1], 0.05, 1e-12);
  const double growth = (s[2] - s[1]) / s[1];
  for (int i = 2; i < 7; ++i) EXPECT_NEAR((s[i + 1] - s[i]) / (s[i] - s[i - 1]), growth, 1e-9);
  // 1 + 1.5 + 2.25 + 3 + 3 ... (largest 3): 10 is reached by five intervals (10.75), 2.5 by two.
  EXPECT_EQ(intervalsFor(10, 1, 1.5, 3), 5);
  EXPECT_EQ(intervalsFor(2.5, 1, 1.5, 3), 2);
  EXPECT_EQ(intervalsFor(0.1, 1, 1.5, 3), 1);
}

}  // namespace
}  // namespace squat::geometry
