// squat export, read back by VTK's own reader as ParaView does: times, cells, the turning wheel, stress and pressure at
// the contact, each against the result file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <regex>

#include "core/DurableFile.h"
#include "growth/GrowthFiles.h"
#include "results/Hdf5.h"
#include "results/SampleResult.h"
#include "scene/SurfaceData.h"
#include "trust/Program.h"

namespace squat {
namespace {

using tests::TemporaryFolder;

struct Instant {
  double time = 0;
  vtkSmartPointer<vtkUnstructuredGrid> surface, patch;
};

vtkSmartPointer<vtkUnstructuredGrid> readGrid(const std::string& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// What the collection links, in its order.
std::vector<Instant> readCollection(const std::string& folder, const std::string& stem) {
  const auto text = readWholeFile(folder + "/" + stem + ".pvd", 1000000);
  const std::regex link("<DataSet timestep=\"([^\"]*)\" part=\"([01])\" file=\"([^\"]*)\"/>");
  std::vector<Instant> instants;
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
    const double time = std::stod((*at)[1]);
    const auto grid = readGrid(folder + "/" + (*at)[3].str());
    if ((*at)[2] == "0")
      instants.push_back({time, grid, nullptr});
    else if (!instants.empty() && instants.back().time == time)
      instants.back().patch = grid;
  }
  return instants;
}

const results::SurfaceSnapshot* snapshotAt(const results::RunResult& result, double time) {
  for (const auto& snapshot : result.snapshots)
    if (std::abs(snapshot.time - time) < 1e-9 * (1 + time)) return &snapshot;  // 9 digits are written
  return nullptr;
}

// The export of the light defect that Call.FiguresPaper has rolled on `tiny`.
class Export : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<TemporaryFolder>();
    const std::string rolled = FIGURES_PAPER_FOLDER "/light-defect.h5";
    ASSERT_EQ(tests::call({"export", rolled, "-o", *folder / "vtk"}), 0);
    result = std::make_unique<results::RunResult>(results::readResult(rolled));
    instants = readCollection(*folder / "vtk", "light-defect");
  }
  static void TearDownTestSuite() { folder.reset(), result.reset(), instants.clear(); }

  static inline std::unique_ptr<TemporaryFolder> folder;
  static inline std::unique_ptr<results::RunResult> result;
  static inline std::vector<Instant> instants;
};

TEST_F(Export, HasEveryInstantOnce) {
  std::vector<double> stored, written;
  for (const auto& snapshot : result->snapshots) stored.push_back(snapshot.time);
  std::sort(stored.begin(), stored.end());
  stored.erase(std::unique(stored.begin(), stored.end()), stored.end());
  for (const auto& instant : instants) written.push_back(instant.time);
  ASSERT_GT(stored.size(), 10u) << "nothing is compared";  // start, impact and 12 frames
  ASSERT_EQ(written.size(), stored.size());
  for (std::size_t i = 0; i < stored.size(); ++i) EXPECT_NEAR(written[i], stored[i], 1e-9 * (1 + stored[i]));
}

TEST_F(Export, HasTheCellsOfTheSurface) {
  for (const auto& instant : instants) {
    ASSERT_EQ(instant.surface->GetNumberOfCells(), static_cast<vtkIdType>(result->surface.part.size()));
    ASSERT_EQ(instant.surface->GetNumberOfPoints(), static_cast<vtkIdType>(result->surface.points.size() / 3));
  }
}

// The wheel rolls: a point of its tread moves about the centre by the radius times the angle, and the centre travels at
// the speed. The centre is that of the wheel at the start plus speed times time; the run turns at speed / radius up to
// its creepage (below 1e-3 without torque) and starts at rest in its own frame.
TEST_F(Export, ARimNodeMovesByRadiusTimesAngle) {
  const auto centre = scene::wheelCentre(result->surface);
  const auto& points = result->surface.points;
  std::size_t rim = 0;  // the foremost point of the wheel: on its outermost radius, away from the contact
  for (std::size_t quad = 0; quad < result->surface.part.size(); ++quad) {
    if (result->surface.partNames[result->surface.part[quad]] != "wheel rim") continue;
    const auto point = static_cast<std::size_t>(result->surface.quads[4 * quad]);
    if (rim == 0 || points[3 * point] > points[3 * rim]) rim = point;
  }
  const double radius = std::hypot(points[3 * rim] - centre[0], points[3 * rim + 2] - centre[2]);
  ASSERT_GT(radius, 0.4);
  const auto angleAt = [&](const Instant& instant) {
    const double* at = instant.surface->GetPoint(static_cast<vtkIdType>(rim));
    const double x = at[0] - centre[0] - result->speed * instant.time, z = at[2] - centre[2];
    return std::atan2(x, z);  // from the top forward, as the wheel turns
  };
  double turned = 0;
  for (const auto& instant : instants) {
    const double angle = std::remainder(angleAt(instant) - angleAt(instants.front()), 2 * M_PI);
    const double expected = result->speed * (instant.time - instants.front().time) / radius;
    // 1e-3 of the way is the creepage; 0.3 mm the displacement of a point under load, which the file holds as well.
    EXPECT_NEAR(radius * angle, radius * std::remainder(expected, 2 * M_PI), 1e-3 * radius * expected + 3e-4);
    turned = std::max(turned, std::abs(angle));
  }
  EXPECT_GT(turned, 0.3) << "the wheel does not turn";
}

TEST_F(Export, StressAndDisplacementAreThoseOfTheResult) {
  for (const auto& instant : instants) {
    const auto* snapshot = snapshotAt(*result, instant.time);
    ASSERT_TRUE(snapshot);
    auto* stress = instant.surface->GetPointData()->GetArray("von Mises stress [Pa]");
    auto* moved = instant.surface->GetPointData()->GetArray("displacement [m]");
    ASSERT_TRUE(stress && moved);
    const double contactAt = scene::wheelCentre(result->surface)[0] + snapshot->wheelTravel;
    double atContact = 0;
    for (vtkIdType i = 0; i < instant.surface->GetNumberOfPoints(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      ASSERT_EQ(static_cast<float>(stress->GetTuple1(i)), snapshot->vonMises[k]);
      ASSERT_EQ(static_cast<float>(moved->GetComponent(i, 2)), snapshot->displacement[3 * k + 2]);
      const double* at = instant.surface->GetPoint(i);
      if (std::hypot(at[0] - contactAt, at[2]) < 0.02) atContact = std::max(atContact, stress->GetTuple1(i));
    }
    // Hertz: about 0.6 of a peak pressure of 1 GPa below the surface, half of it on it; far above what bends the rail.
    EXPECT_GT(atContact, 100e6) << "no contact where the wheel stands";
  }
}

// Every point under pressure is there with its value, and the patch lies where the wheel stands.
TEST_F(Export, PressureIsThatOfTheResultAndLiesUnderTheWheel) {
  int compared = 0;
  for (const auto& instant : instants) {
    if (!instant.patch) continue;
    const auto* snapshot = snapshotAt(*result, instant.time);
    ASSERT_TRUE(snapshot);
    const auto patch = std::find_if(result->patches.begin(), result->patches.end(),
                                    [&](const auto& each) { return each.name == snapshot->name; });
    ASSERT_NE(patch, result->patches.end());
    std::vector<float> pressed;
    std::copy_if(patch->pressure.begin(), patch->pressure.end(), std::back_inserter(pressed),
                 [](float pressure) { return pressure > 0; });
    auto* pressure = instant.patch->GetCellData()->GetArray("contact pressure [Pa]");
    ASSERT_TRUE(pressure);
    ASSERT_EQ(pressure->GetNumberOfTuples(), static_cast<vtkIdType>(pressed.size()));
    for (std::size_t i = 0; i < pressed.size(); ++i)
      ASSERT_EQ(static_cast<float>(pressure->GetTuple1(static_cast<vtkIdType>(i))), pressed[i]);
    const double contactAt = scene::wheelCentre(result->surface)[0] + snapshot->wheelTravel;
    double bounds[6];
    instant.patch->GetBounds(bounds);
    // The patch of the mesh `tiny` is some 15 mm long; the rail bends by less than 3 mm under the wheel.
    EXPECT_NEAR(0.5 * (bounds[0] + bounds[1]), contactAt, 0.01);
    EXPECT_LT(bounds[1] - bounds[0], 0.04);
    EXPECT_GT(bounds[4], -0.003);
    ++compared;
  }
  EXPECT_GT(compared, 10) << "nothing is compared";
}

// The stages of a growth stand at their tonnages; heights and changes are those of the file, in their places.
TEST(ExportOfAGrowth, HasAGridForEachStage) {
  const TemporaryFolder folder;
  growth::Growth growth;
  growth.x = {-0.01, 0, 0.01}, growth.y = {-0.005, 0.005};
  growth.stages.resize(2);
  growth.stages[1].tonnage = 2.5e9;
  growth.shapes = {{0, 0, -1e-4, -1e-4, 0, 0}, {0, 0, -2e-4, -1.5e-4, 0, 1e-6}};
  growth.wear = growth.flow = growth::Field(6, 0.0);
  const auto path = folder / "dip-growth.h5";
  const auto bytes = results::encodeHdf5(growth::growthTree(growth), path);
  writeDurably(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  ASSERT_EQ(tests::call({"export", path, "-o", folder / "vtk"}), 0);
  const auto stages = readCollection(folder / "vtk", "dip-growth");
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].time, 0);
  EXPECT_EQ(stages[1].time, 2.5);
  auto& grid = *stages[1].surface;
  ASSERT_EQ(grid.GetNumberOfCells(), 2);
  ASSERT_EQ(grid.GetNumberOfPoints(), 6);
  EXPECT_NEAR(grid.GetPoint(3)[0], 0, 1e-9);
  EXPECT_NEAR(grid.GetPoint(3)[1], 0.005, 1e-9);
  EXPECT_NEAR(grid.GetPoint(3)[2], -1.5e-4, 1e-9);
  EXPECT_NEAR(grid.GetPointData()->GetArray("height [m]")->GetTuple1(2), -2e-4, 1e-10);
  EXPECT_NEAR(grid.GetPointData()->GetArray("change [m]")->GetTuple1(2), -1e-4, 1e-10);
}

}  // namespace
}  // namespace squat
