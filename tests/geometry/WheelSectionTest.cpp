// Sections of the half wheelset: a web that is conical and tapered keeps the volume that integral calculus gives it.
#include "geometry/WheelSection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "FixtureCase.h"
#include "case/CaseFile.h"

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

}  // namespace
}  // namespace squat::geometry
