// Cells of a contact patch: by hand for two faces of 4 x 4 mm with 2 x 2 points each at the places of Gauss.
#include "results/PatchCells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::results {
namespace {

constexpr double face = 4e-3, round = 1e-8;  // [m]; places are kept in single precision

PatchSnapshot twoFaces() {
  PatchSnapshot patch;
  const double gauss = face / 2 / std::sqrt(3.0);
  for (const double middle : {0.0, face})
    for (const double x : {-gauss, gauss})
      for (const double y : {-gauss, gauss}) {
        patch.x.push_back(static_cast<float>(middle + x));
        patch.y.push_back(static_cast<float>(y));
        patch.pressure.push_back(1e9f);
        patch.area.push_back(static_cast<float>(face * face / 4));
      }
  return patch;
}

TEST(PatchCells, bordersLieHalfWayBetweenThePoints) {
  const auto cells = patchCells(twoFaces());
  ASSERT_EQ(cells.size(), 8u);
  const double gauss = face / 2 / std::sqrt(3.0);
  EXPECT_NEAR(cells[0].left, -2 * gauss, round);  // as wide outside as inside
  EXPECT_NEAR(cells[0].right, 0, round);
  EXPECT_NEAR(cells[2].right, face / 2, round);  // the border of the faces
  EXPECT_NEAR(cells[4].left, face / 2, round);
  EXPECT_NEAR(cells[0].near, -2 * gauss, round);
  EXPECT_NEAR(cells[0].far, 0, round);
  EXPECT_NEAR(cells[1].far, 2 * gauss, round);
}

TEST(PatchCells, fillThePatchWithoutGaps) {
  const auto cells = patchCells(twoFaces());
  double area = 0;
  for (const PatchCell& cell : cells) area += (cell.right - cell.left) * (cell.far - cell.near);
  const double gauss = face / 2 / std::sqrt(3.0);
  EXPECT_NEAR(area, (face + 4 * gauss) * 4 * gauss, 1e-10);
}

TEST(PatchCells, aPointAloneHasASquareOfItsArea) {
  PatchSnapshot patch;
  patch.x = {0.001f}, patch.y = {-0.002f}, patch.pressure = {1e9f}, patch.area = {4e-6f};
  const auto cells = patchCells(patch);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_NEAR(cells[0].left, 0, round);
  EXPECT_NEAR(cells[0].right, 0.002, round);
  EXPECT_NEAR(cells[0].near, -0.003, round);
  EXPECT_NEAR(cells[0].far, -0.001, round);
}

TEST(PatchCells, aDamagedPatchHasNone) {
  PatchSnapshot patch = twoFaces();
  patch.x.pop_back();
  EXPECT_TRUE(patchCells(patch).empty());
  EXPECT_TRUE(patchCells({}).empty());
}

}  // namespace
}  // namespace squat::results
