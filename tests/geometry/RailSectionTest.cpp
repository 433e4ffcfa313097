// Section of the 54E1 rail: outline against the numbers of EN 13674-1 and published integrals, mesh quality.
//
// Targets: area 69.75 cm2, centroid 75.16 mm above the base, I_y 2337.9 cm4 (vertical bending), I_z 419.0 cm4; a fit of
// the undrawn lower part, itself within 0.05 % of the published 69.77 cm2, 75.1 mm, 2337.9 and 419.2 cm4. Tolerance
// 0.5 %: straight sides of quads instead of arcs cut about (size)^2 / 8R off.
#include "geometry/RailSection.h"
#include "verification/Seen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace squat::geometry {
namespace {

constexpr RailSectionSizes fine{0.0013, 0.0078, 0.010, 1.33};
constexpr double outlineHeight = 0.159;

TEST(RailSection, IntegralsAreThoseOf54E1) {
  const auto integrals = sectionIntegrals(railSectionMesh(RailSection::rail54E1, fine));
  EXPECT_NEAR(integrals.area, 69.75e-4, 0.005 * 69.75e-4);
  EXPECT_NEAR(integrals.centroidC + outlineHeight, 75.16e-3, 0.005 * 75.16e-3);
  EXPECT_NEAR(integrals.momentCC, 2337.9e-8, 0.005 * 2337.9e-8);
  EXPECT_NEAR(integrals.momentBB, 419.0e-8, 0.005 * 419.0e-8);
  verification::seenDeviation("area", integrals.area, 69.75e-4);
  verification::seenDeviation("moments", integrals.momentCC, 2337.9e-8);
  verification::seenDeviation("moments", integrals.momentBB, 419.0e-8);
  EXPECT_NEAR(integrals.centroidB, 0, 1e-12);  // mirrored
}

// Height 159, head 70 wide at the 1:20 sides' start and 72.2 at the lower corner, foot 140 (EN 13674-1).
TEST(RailSection, OutlineHasTheStandardsDimensions) {
  const auto mesh = railSectionMesh(RailSection::rail54E1, fine);
  double low = 0, high = -1, head = 0, foot = 0;
  for (const auto& p : mesh.nodes) {
    low = std::min(low, p[1]), high = std::max(high, p[1]);
    (p[1] > -0.05 ? head : foot) = std::max(p[1] > -0.05 ? head : foot, p[0]);
  }
  EXPECT_NEAR(high, 0, 1e-12);
  EXPECT_NEAR(low, -0.159, 1e-9);
  EXPECT_NEAR(foot, 0.070, 1e-9);
  EXPECT_NEAR(2 * head, 0.0722, 0.0001);
  double web = 1;
  for (const auto& p : railOutline(RailSection::rail54E1).web) web = std::min(web, p[0]);
  EXPECT_NEAR(2 * web, 0.016, 1e-4);
}

// Arcs of the crown: R300 up to 10.012 mm, R80 beyond; the heights at the arcs' ends follow from the tangency of
// R300, R80 and R13: 0.167 mm and 2.065 mm below the crown.
TEST(RailSection, CrownIsMadeOfTangentArcs) {
  EXPECT_NEAR(crownHeight(RailSection::rail54E1, 0), 0, 1e-15);
  EXPECT_NEAR(crownHeight(RailSection::rail54E1, 0.005), -(0.3 - std::sqrt(0.3 * 0.3 - 0.005 * 0.005)), 1e-12);
  EXPECT_NEAR(crownHeight(RailSection::rail54E1, 0.010012), -0.167e-3, 0.5e-6);
  EXPECT_NEAR(crownHeight(RailSection::rail54E1, 0.0248635), -2.065e-3, 1e-6);
  const double step = 1e-7;
  for (const double y : {-0.02, -0.012, -0.010012, -0.003, 0.001, 0.0099, 0.010012, 0.0101, 0.018, 0.0248}) {
    EXPECT_NEAR(
        crownSlope(RailSection::rail54E1, y),
        (crownHeight(RailSection::rail54E1, y + step) - crownHeight(RailSection::rail54E1, y - step)) / (2 * step),
        1e-5);
    EXPECT_DOUBLE_EQ(crownHeight(RailSection::rail54E1, -y), crownHeight(RailSection::rail54E1, y));
    EXPECT_DOUBLE_EQ(crownSlope(RailSection::rail54E1, -y), -crownSlope(RailSection::rail54E1, y));
  }
}

// Three columns of the band become one below: the outline, and with it the integrals, stays, the surface as well;
// twelve columns of three rows of the head, of the web and of the foot become four. Every quad has an area.
TEST(RailSection, CoarseWebKeepsOutlineAndBand) {
  RailSectionSizes sizes = fine;
  sizes.coarseBelow = true;
  const auto coarse = railSectionMesh(RailSection::rail54E1, sizes),
             whole = railSectionMesh(RailSection::rail54E1, fine);
  const auto a = sectionIntegrals(coarse), b = sectionIntegrals(whole);
  EXPECT_NEAR(a.area, b.area, 1e-12);
  EXPECT_NEAR(a.momentCC, b.momentCC, 1e-5 * b.momentCC);
  EXPECT_NEAR(a.momentBB, b.momentBB, 1e-5 * b.momentBB);
  EXPECT_LT(coarse.quads.size(), 0.78 * static_cast<double>(whole.quads.size()));
  const auto above = [](const SectionMesh& mesh) {
    return nodesWhere(
               mesh, [](const Point2& p) { return p[1] > -0.010; }, 0)
        .size();
  };
  EXPECT_EQ(above(coarse), above(whole)) << "the patch, 7 mm long, has the same mesh under it";
  for (int q = 0; q < static_cast<int>(coarse.quads.size()); ++q) EXPECT_GT(scaledJacobian(coarse, q), 0.3);
  // Half a band of four columns has no three to join.
  sizes.bandHalfWidth = 0.0052;
  RailSectionSizes asBefore = sizes;
  asBefore.coarseBelow = false;
  EXPECT_EQ(railSectionMesh(RailSection::rail54E1, sizes).quads.size(),
            railSectionMesh(RailSection::rail54E1, asBefore).quads.size());
}

TEST(RailSection, ContactBandHasTheAskedSize) {
  const auto mesh = railSectionMesh(RailSection::rail54E1, fine);
  const auto top = nodesWhere(
      mesh,
      [](const Point2& p) {
        return std::abs(p[0]) < 0.0079 && std::abs(p[1] - crownHeight(RailSection::rail54E1, p[0])) < 1e-6;
      },
      0);
  ASSERT_EQ(top.size(), 13u);  // 2 x 7.8 mm / 1.3 mm
  for (std::size_t i = 1; i < top.size(); ++i) {
    const auto &p = mesh.nodes[top[i - 1]], &q = mesh.nodes[top[i]];
    // Chords of equal arcs: 1.3 mm but for the crown's curvature over the band.
    EXPECT_NEAR(std::hypot(q[0] - p[0], q[1] - p[1]), 0.0013, 1e-6);
  }
}

TEST(RailSection, IsMirrored) {
  const auto mesh = railSectionMesh(RailSection::rail54E1, fine);
  for (const auto& p : mesh.nodes) {
    const bool found = std::any_of(mesh.nodes.begin(), mesh.nodes.end(), [&](const Point2& q) {
      return std::abs(p[0] + q[0]) < 1e-9 && std::abs(p[1] - q[1]) < 1e-9;
    });
    ASSERT_TRUE(found) << p[0] << " " << p[1];
  }
}

}  // namespace
}  // namespace squat::geometry
