// The 3-D picture: geometry in closed form, pixels in statistics.
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <utility>

#include "case/CaseDescription.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "render/SyntheticSurface.h"
#include "scene/ModelPicture.h"
#include "scene/PatchFaces.h"
#include "scene/SecondWheelset.h"
#include "scene/SurfaceData.h"
#include "scene/VtkExport.h"

namespace squat {
namespace {

// One quad of the wheel and one of the rail; wheel centre at (1, 0, 0.5) by two further quads.
results::SurfaceMesh fourQuads() {
  results::SurfaceMesh mesh;
  mesh.partNames = {"rail", "wheel rim"};
  mesh.points = {0,    0, 0,    1,    0, 0,    1,    1, 0,    0,    1, 0,     // rail
                 0.5f, 0, 0.5f, 0.5f, 1, 0.5f, 1.5f, 1, 0.5f, 1.5f, 0, 0.5f,  // wheel, level through the centre
                 1,    0, 0,    1,    1, 0,    1,    1, 1,    1,    0, 1};    // wheel, upright through the centre
  mesh.quads = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  mesh.part = {0, 1, 1};
  return mesh;
}

TEST(SurfaceData, wheelRollsAndRailStays) {
  const auto mesh = fourQuads();
  results::SurfaceSnapshot snapshot;
  snapshot.wheelTravel = 2;
  snapshot.wheelRotation = M_PI / 2;
  snapshot.displacement.assign(mesh.points.size(), 0.0f);
  snapshot.displacement[2] = 0.01f;  // first rail point up
  const auto parts = scene::partData(mesh, &snapshot, scene::Field::none, 10);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].faces->GetPoint(0)[2], 0.1, 1e-6);  // 10 times exaggerated
  // A quarter of a turn carries the top (1, 1) to the front (1.5, 0.5), then 2 m on: tolerance of single precision.
  const double* top = parts[1].faces->GetPoint(6);
  EXPECT_NEAR(top[0], 3.5, 1e-6);
  EXPECT_NEAR(top[2], 0.5, 1e-6);
}

TEST(SurfaceData, fieldsComeInTheirUnits) {
  const auto mesh = fourQuads();
  results::SurfaceSnapshot snapshot;
  snapshot.vonMises.assign(12, 250e6f);
  snapshot.displacement.assign(36, 0.0f);
  snapshot.displacement[0] = 3e-6f;
  snapshot.displacement[1] = 4e-6f;
  const auto stress = scene::partData(mesh, &snapshot, scene::Field::vonMises, 1);
  EXPECT_NEAR(stress[0].faces->GetPointData()->GetScalars()->GetTuple1(0), 250, 1e-3);  // MPa
  const auto moved = scene::partData(mesh, &snapshot, scene::Field::displacement, 1);
  EXPECT_NEAR(moved[0].faces->GetPointData()->GetScalars()->GetTuple1(0), 5, 1e-5);  // um
}

TEST(SurfaceData, brokenIndicesAreLeftOut) {
  auto mesh = fourQuads();
  mesh.quads[1] = 999;
  mesh.quads[5] = -4;
  const auto parts = scene::partData(mesh, nullptr, scene::Field::none, 1);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].faces->GetNumberOfPolys(), 1);
}

// Share of pixels of about the given colour.
double share(const scene::Picture& picture, int red, int green, int blue, int tolerance) {
  long long count = 0;
  for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
    count += std::abs(picture.rgb[i] - red) <= tolerance && std::abs(picture.rgb[i + 1] - green) <= tolerance &&
             std::abs(picture.rgb[i + 2] - blue) <= tolerance;
  return static_cast<double>(count) / (picture.rgb.size() / 3.0);
}

TEST(ModelPicture, showsPartsSpringsAndStress) {
  std::string reason;
  const auto picture = scene::modelPicture(tests::syntheticResult(), "viridis", reason);
  ASSERT_FALSE(picture.empty()) << reason;
  EXPECT_EQ(picture.width, 2008);                     // 170 mm at 300 dpi
  EXPECT_GT(share(picture, 255, 255, 255, 0), 0.1);   // paper
  EXPECT_LT(share(picture, 0, 0, 0, 2), 0.02);        // no black hole
  EXPECT_GT(share(picture, 204, 51, 38, 40), 1e-4);   // springs
  EXPECT_GT(share(picture, 253, 231, 37, 30), 5e-4);  // highest stress and the end of the bar
  EXPECT_GT(share(picture, 68, 1, 84, 25), 0.1);      // lowest stress
}

// Letters keep their size on paper: the picture of twice the resolution, halved, is the same picture.
TEST(ModelPicture, hasTheSizeThatIsAskedFor) {
  std::string reason;
  const auto result = tests::syntheticResult();
  const auto plain = scene::modelPicture(result, "viridis", reason, {127, 76.2, 300});
  const auto fine = scene::modelPicture(result, "viridis", reason, {127, 76.2, 600});
  ASSERT_FALSE(plain.empty() || fine.empty()) << reason;
  EXPECT_EQ(plain.width, 1500);  // 127 mm are 5 inches
  EXPECT_EQ(plain.height, 900);
  EXPECT_EQ(fine.width, 3000);
  EXPECT_EQ(fine.height, 1800);
  // Shares of paper and of the lowest stress: lines are never thinner than a pixel, which takes 1 % of the pixels.
  EXPECT_NEAR(share(plain, 255, 255, 255, 0), share(fine, 255, 255, 255, 0), 0.02);
  EXPECT_NEAR(share(plain, 68, 1, 84, 25), share(fine, 68, 1, 84, 25), 0.02);
  EXPECT_TRUE(scene::modelPicture(result, "viridis", reason, {400, 200, 1200}).empty());
  EXPECT_NE(reason.find("8192"), std::string::npos) << reason;
}

// The crown, 64 mm wide, is a band of 50 mm across the close-up's view of 80 x 90 mm: 0.59 of it, and the close-up is
// 0.44 x 0.93 of the picture, so the crown 0.24 of it. Lines of the mesh, 2 pixels in 34, take a sixteenth of that; a
// third is left for how a driver draws edges. The overview alone has 0.02. The colour is the rail's times 0.25 + 0.75
// cos of the angle (42 degrees) between the crown's normal and the view; 6 degrees more or less at its edges change it
// by 8.
TEST(ModelPicture, withoutSnapshotOrCutFacesTheRailIsSeen) {
  auto result = tests::syntheticResult();
  result.snapshots.clear();
  for (auto& name : result.surface.partNames)
    if (scene::isCutFace(name)) name.replace(name.rfind(" cut"), 4, " inside");
  std::string reason;
  const auto picture = scene::modelPicture(result, "jet", reason);
  ASSERT_FALSE(picture.empty()) << reason;
  EXPECT_GT(share(picture, 74, 107, 140, 12), 0.15);
}

// The colours of the left contact's close-up stand for the stress of both: three times as much on the right widens the
// scale from 630 to 1560 MPa. About the contact, stress falls as a bell of 11 x 9 mm; some 3 cm2 of it lie between what
// is dark on either scale (8 % of it, about), some 8 % of the close-up, which is 0.41 of the picture.
TEST(ModelPicture, bothContactsCountInTheColours) {
  const auto even = tests::syntheticWhole(1), uneven = tests::syntheticWhole(3);
  const auto highest = [](const results::RunResult& result) {
    return scene::largestNearContact(result.surface, result.snapshots.at(0), scene::Field::vonMises, 0.03);
  };
  EXPECT_NEAR(highest(even), highest(tests::syntheticResult()), 1e-3);
  EXPECT_NEAR(highest(uneven), 3 * highest(tests::withoutCutFaces(tests::syntheticResult())), 1e-3);
  std::string reason;
  const auto bright = scene::modelPicture(even, "viridis", reason);
  const auto dark = scene::modelPicture(uneven, "viridis", reason);
  ASSERT_FALSE(bright.empty() || dark.empty()) << reason;
  EXPECT_GT(share(dark, 68, 1, 84, 25), share(bright, 68, 1, 84, 25) + 0.01);
}

void giveBogie(results::RunResult& result, const char* wheelbase, const char* place) {
  auto description = cases::defaultCase();
  cases::setValue(description, "bogie.wheelbase", wheelbase);
  cases::setValue(description, "bogie.second_wheelset", place);
  results::setCase(result, description);
}

// The wheel of four quads, 1 m wide and high, has rolled 2 m and a quarter of a turn from x = 1 m; the second one
// stands 2.5 m behind it or ahead, and knows nothing of displacements.
TEST(SecondWheelset, isTheFirstOneAtItsPlace) {
  results::RunResult result;
  result.surface = fourQuads();
  results::SurfaceSnapshot snapshot;
  snapshot.wheelTravel = 2, snapshot.wheelRotation = M_PI / 2;
  snapshot.displacement.assign(result.surface.points.size(), 0.1f);
  EXPECT_TRUE(scene::secondWheelsetActors(result, &snapshot, {}).empty());  // no case
  for (const auto& [place, from] : {std::pair{"behind", -2.5}, {"ahead", 2.5}}) {
    giveBogie(result, "2.5", place);
    EXPECT_DOUBLE_EQ(scene::secondWheelsetFrom(result), from);
    const auto actors = scene::secondWheelsetActors(result, &snapshot, {});
    ASSERT_EQ(actors.size(), 1u);  // the rail has no second one
    const double* bounds = actors[0]->GetBounds();
    const double expected[] = {3 + from - 0.5, 3 + from + 0.5, 0, 1, 0, 1};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(bounds[i], expected[i], 1e-5) << place << i;
  }
  giveBogie(result, "0", "behind");
  EXPECT_TRUE(scene::secondWheelsetActors(result, &snapshot, {}).empty());
}

// The left part of a picture.
scene::Picture leftOf(const scene::Picture& all, double share) {
  scene::Picture part = all;
  part.width = static_cast<int>(share * all.width);
  part.rgb.clear();
  for (int y = 0; y < all.height; ++y) {
    const auto row = all.rgb.begin() + 3L * y * all.width;
    part.rgb.insert(part.rgb.end(), row, row + 3L * part.width);
  }
  return part;
}

// Edges of the rim, some five circles of 0.46 m at 250 pixels a metre: 3600 pixels, in lines of which half are thinned
// out at their borders. The wheel is in the left 0.15 of the picture, 320 thousand pixels.
TEST(SecondWheelset, isSeenAsGreyLines) {
  std::string reason;
  auto result = tests::syntheticResult();
  const auto single = scene::modelPicture(result, "viridis", reason);
  giveBogie(result, "2.5", "behind");
  const auto both = scene::modelPicture(result, "viridis", reason);
  ASSERT_FALSE(single.empty() || both.empty()) << reason;
  EXPECT_GT(share(leftOf(both, 0.15), 128, 128, 128, 12), share(leftOf(single, 0.15), 128, 128, 128, 12) + 0.005);
}

TEST(ModelPicture, withoutASurfaceItSaysWhy) {
  std::string reason;
  EXPECT_TRUE(scene::modelPicture({}, "viridis", reason).empty());
  EXPECT_EQ(reason, "the result has no surface of the model");
}

// What another program reads from a file: every point where its displacement has taken it, every quad, every field in
// SI units, all to the bit of single precision.
void expectSameGrid(const std::string& path, const results::SurfaceMesh& surface,
                    const results::SurfaceSnapshot& snapshot) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* grid = reader->GetOutput();
  ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(surface.points.size() / 3)) << path;
  ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(surface.part.size())) << path;
  const auto locations = scene::locationsOf(surface, snapshot, 1);
  auto* moved = grid->GetPointData()->GetArray("displacement [m]");
  auto* stress = grid->GetPointData()->GetArray("von Mises stress [Pa]");
  auto* part = grid->GetCellData()->GetArray("part");
  ASSERT_TRUE(moved && stress && part) << path;
  double largest = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(3 * i + c);
      ASSERT_EQ(static_cast<float>(moved->GetComponent(i, c)), snapshot.displacement[k]) << path << " " << k;
      ASSERT_EQ(static_cast<float>(grid->GetPoint(i)[c]), locations[k]) << path << " " << k;
    }
    ASSERT_EQ(static_cast<float>(stress->GetTuple1(i)), snapshot.vonMises[static_cast<std::size_t>(i)]) << path;
    largest = std::max(largest, stress->GetTuple1(i));
  }
  EXPECT_GT(largest, 0) << "nothing is compared";
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    ASSERT_EQ(part->GetTuple1(i), surface.part[static_cast<std::size_t>(i)]);
    for (int corner = 0; corner < 4; ++corner)
      ASSERT_EQ(grid->GetCell(i)->GetPointId(corner), surface.quads[static_cast<std::size_t>(4 * i + corner)]);
  }
}

// Two instants, the first of them under two names and with a patch.
TEST(VtkExport, writesEachInstantOnceAndItsTime) {
  const std::string folder = tests::freshFolder("vtk");
  auto result = tests::syntheticResult();
  ASSERT_EQ(result.snapshots.size(), 1u);
  auto again = result.snapshots.front(), later = again;
  again.name = "frame 04";
  later.name = "frame 05";
  later.time += 0.5e-3;
  result.snapshots.push_back(again);
  result.snapshots.push_back(later);
  const auto written = scene::writeVtkSeries(result, folder);
  ASSERT_EQ(written.size(), 4u);  // two surfaces, a patch, the collection
  expectSameGrid(written[0], result.surface, result.snapshots[0]);
  expectSameGrid(written[2], result.surface, result.snapshots[2]);
  EXPECT_NE(written[1].find("light-defect_patch_000.vtu"), std::string::npos);
  std::ifstream collection(written.back());
  const std::string text((std::istreambuf_iterator<char>(collection)), {});
  EXPECT_NE(text.find("light-defect_002.vtu"), std::string::npos);
  EXPECT_EQ(text.find("light-defect_001.vtu"), std::string::npos);
  EXPECT_THROW(scene::writeVtkSeries({}, folder), FileError);
}

// A point 3 mm outwards from the right rail's axis stands at -1.5 m - 3 mm, and what pushes outwards there pushes to
// the right.
TEST(PatchFaces, theRightContactIsTheMirrorImageOfItsNumbers) {
  auto result = tests::syntheticWhole(1);
  results::PatchSnapshot left, right;
  left.x = right.x = {0.001f}, left.y = right.y = {0.003f}, left.pressure = right.pressure = {1e9f};
  left.tractionY = right.tractionY = {2e8f};
  left.right = std::make_shared<const results::PatchSnapshot>(right);
  const auto contacts = scene::contactsInPlace(left, result.surface);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].y, left.y);
  EXPECT_NEAR(contacts[1].y[0], -1.503, 1e-6);
  EXPECT_EQ(contacts[1].x, right.x);
  EXPECT_EQ(contacts[1].tractionY[0], -2e8f);
  right.y.clear();
  left.right = std::make_shared<const results::PatchSnapshot>(right);
  EXPECT_EQ(scene::contactsInPlace(left, result.surface).size(), 1u);
}

// Each contact lies on its own rail, at one height in mirror images, with its own pressure.
TEST(VtkExport, aWholeModelsPatchesLieOnBothRails) {
  const auto result = tests::syntheticWhole(2);
  const auto written = scene::writeVtkSeries(result, tests::freshFolder("vtk-whole"));
  ASSERT_EQ(written.size(), 3u);  // a surface, both patches, the collection
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(written[1].c_str());
  reader->Update();
  auto* grid = reader->GetOutput();
  const auto& pressure = result.patches[0].pressure;
  const auto under = std::count_if(pressure.begin(), pressure.end(), [](float each) { return each > 0; });
  ASSERT_EQ(grid->GetNumberOfCells(), 2 * under);
  auto* values = grid->GetCellData()->GetArray("contact pressure [Pa]");
  ASSERT_TRUE(values);
  for (vtkIdType i = 0; i < under; ++i) {
    double left[6], right[6];
    grid->GetCell(i)->GetBounds(left);
    grid->GetCell(i + under)->GetBounds(right);
    EXPECT_NEAR(left[2] + right[3], -1.5, 1e-5);  // near and far edges change places
    EXPECT_NEAR(left[4], right[4], 1e-5);
    EXPECT_EQ(left[0], right[0]);
    EXPECT_FLOAT_EQ(static_cast<float>(values->GetTuple1(i + under)), 2 * static_cast<float>(values->GetTuple1(i)));
  }
}

}  // namespace
}  // namespace squat
