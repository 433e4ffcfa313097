// Sections of the half wheelset: volumes as integral calculus gives them, elements that never get thin.
#include "geometry/WheelSection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "FixtureCase.h"
#include "RandomWheelsets.h"
#include "case/CaseFile.h"
#include "scenario/WheelsetMass.h"

namespace squat::geometry {
namespace {

constexpr WheelSectionSizes kSizes{0.016, 0, 0.016, 1.5, 0.025};

// Guldin: volume of the body that a section makes about the axis.
double volume(const cases::Wheelset& w) {
  const auto integrals = sectionIntegrals(wheelBodySectionMesh(w, kSizes));
  return 2 * std::numbers::pi * integrals.centroidB * integrals.area;
}

// Web between radii a and b, its thickness straight from t at b to h at a: 2 pi int r t(r) dr.
double webVolume(double a, double b, double h, double t) {
  const double slope = (t - h) / (b - a), start = h - slope * a;
  return 2 * std::numbers::pi * (start * (b * b - a * a) / 2 + slope * (b * b * b - a * a * a) / 3);
}

TEST(WheelSection, ConicalAndTaperedWebHasTheVolumeOfItsDrawing) {
  auto w = cases::loadCase(tests::fixtureCase("smooth-rail")).wheelset;
  const double straight = volume(w);
  w.webOffset = 0.035, w.webHubThickness = 0.045;
  const auto mesh = wheelBodySectionMesh(w, kSizes);
  for (int q = 0; q < static_cast<int>(mesh.quads.size()); ++q) EXPECT_GT(scaledJacobian(mesh, q), 0.5);
  const double gained = webVolume(w.hubRadius, w.rimInnerRadius, w.webHubThickness, w.webThickness) -
                        webVolume(w.hubRadius, w.rimInnerRadius, w.webThickness, w.webThickness);
  EXPECT_NEAR(volume(w) - straight, gained, 1e-9 * straight);  // straight edges: exact but for round-off
  // The middle of the web runs from the wheel plane at the rim to the offset at the hub.
  double outermost = -1;
  for (const auto& p : mesh.nodes)
    if (p[0] > w.hubRadius + 1e-6 && p[0] < w.rimInnerRadius - 1e-6) outermost = std::max(outermost, p[1]);
  EXPECT_LT(outermost, w.webOffset + 0.5 * w.webHubThickness);
  EXPECT_GT(outermost, w.webOffset);
}

// The drawing's volume without the rim's outer part: no step of the default drawing is below 12 mm.
TEST(WheelSection, HasTheVolumeOfItsDrawing) {
  const auto w = cases::loadCase(tests::fixtureCase("smooth-rail")).wheelset;
  const double outer = w.radius - kSizes.rimDepth;
  const double expected =
      scenario::wheelsetSolid(w).volume - std::numbers::pi * (w.radius * w.radius - outer * outer) * w.rimWidth;
  EXPECT_NEAR(volume(w), expected, 1e-9 * expected);
}

// Surfaces 5 mm apart share a line of nodes: a journal of 75 mm ends a shoulder of 80 mm with a frustum as long as the
// last elements, so that the volume is less by half the step over their length.
TEST(WheelSection, ASmallStepIsATaper) {
  auto w = cases::loadCase(tests::fixtureCase("smooth-rail")).wheelset;
  w.journalRadius = 0.075;
  const auto mesh = wheelBodySectionMesh(w, kSizes);
  const auto surface = nodesWhere(
      mesh, [&](const Point2& p) { return std::abs(p[0] - w.journalRadius) < 1e-9; }, 1);
  EXPECT_NEAR(mesh.nodes[surface.front()][1], w.shoulderEnd, 1e-9);
  const double a = w.shoulderRadius, b = w.journalRadius, length = (w.shoulderEnd - 0.5 * w.hubWidth) / 2;
  const double taken = std::numbers::pi * length * (a * a - (a * a + a * b + b * b) / 3);
  const double outer = w.radius - kSizes.rimDepth;
  const double expected =
      scenario::wheelsetSolid(w).volume - std::numbers::pi * (w.radius * w.radius - outer * outer) * w.rimWidth - taken;
  EXPECT_NEAR(volume(w), expected, 1e-9 * expected);
}

double distance(const Point2& a, const Point2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

// Shortest edge of a quad.
double shortestEdge(const SectionMesh& mesh, const std::array<int, 4>& quad) {
  double shortest = 1e9;
  for (int i = 0; i < 4; ++i)
    shortest = std::min(shortest, distance(mesh.nodes[quad[i]], mesh.nodes[quad[(i + 1) % 4]]));
  return shortest;
}

// Nothing of a drawing makes an element thinner than 12 mm but a tube or a hub whose wall is thinner, and a web that
// is. Skew is the drawing's own, as where an axle of 40 mm carries a seat of 200: no corner comes within a degree of
// flat.
TEST(WheelSection, NoElementIsThinWhateverTheDrawing) {
  tests::RandomWheelsets wheelsets(7);
  for (int i = 0; i < 200; ++i) {
    const auto w = cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", wheelsets.next()}).wheelset;
    const auto mesh = wheelBodySectionMesh(w, kSizes);
    const double thinnest = std::min({w.axleRadius, w.shoulderRadius, w.journalRadius});
    const double wall = thinnest - std::max(w.boreRadius, std::min(0.025, 0.3 * thinnest));
    const double web = w.webHubThickness > 0 ? std::min(w.webThickness, w.webHubThickness) : w.webThickness;
    const double parts = std::min({wall, web / 2, (w.radius - kSizes.rimDepth - w.hubRadius) / 2});
    const double limit = 0.999 * std::min(0.012, parts);
    for (int q = 0; q < static_cast<int>(mesh.quads.size()); ++q) {
      EXPECT_GE(shortestEdge(mesh, mesh.quads[q]), limit) << i;
      EXPECT_GT(scaledJacobian(mesh, q), std::sin(std::numbers::pi / 180)) << i;
    }
  }
}

}  // namespace
}  // namespace squat::geometry
