#include "scene/VtkExport.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "analysis/AnalysisFiles.h"
#include "core/Errors.h"
#include "scene/PatchFaces.h"
#include "scene/SurfaceData.h"
#include "scene/VtkCollection.h"

namespace squat::scene {
namespace {

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

// Values of all points; left out where there are none.
void addField(vtkUnstructuredGrid& grid, const char* name, const std::vector<float>& values, int components) {
  if (values.size() != static_cast<std::size_t>(grid.GetNumberOfPoints() * components)) return;
  vtkNew<vtkFloatArray> field;
  field->SetName(name);
  field->SetNumberOfComponents(components);
  field->SetNumberOfTuples(grid.GetNumberOfPoints());
  std::copy(values.begin(), values.end(), field->GetPointer(0));
  grid.GetPointData()->AddArray(field);
}

void addQuads(vtkUnstructuredGrid& grid, const results::SurfaceMesh& surface) {
  vtkNew<vtkUnsignedCharArray> part;
  part->SetName("part");
  for (std::size_t quad = 0; quad < surface.part.size() && 4 * quad + 3 < surface.quads.size(); ++quad) {
    vtkIdType corners[4];
    bool valid = true;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      corners[corner] = surface.quads[4 * quad + corner];
      valid = valid && corners[corner] >= 0 && corners[corner] < grid.GetNumberOfPoints();
    }
    if (!valid) continue;
    grid.InsertNextCell(VTK_QUAD, 4, corners);
    part->InsertNextValue(surface.part[quad]);
  }
  grid.GetCellData()->AddArray(part);
  vtkNew<vtkStringArray> names;
  names->SetName("part names");
  for (const auto& name : surface.partNames) names->InsertNextValue(name);
  grid.GetFieldData()->AddArray(names);
}

// From the place at the start to where rolling alone has taken each point.
std::vector<float> rolledBy(const results::SurfaceMesh& surface, const results::SurfaceSnapshot& snapshot) {
  auto rolled = locationsOf(surface, snapshot, 0);
  for (std::size_t i = 0; i < rolled.size(); ++i) rolled[i] -= surface.points[i];
  return rolled;
}

Grid surfaceGrid(const results::SurfaceMesh& surface, const results::SurfaceSnapshot& snapshot) {
  const std::vector<float> locations = locationsOf(surface, snapshot, 1.0);
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  const auto count = static_cast<vtkIdType>(locations.size() / 3);
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i) points->SetPoint(i, &locations[static_cast<std::size_t>(3 * i)]);
  grid->SetPoints(points);
  addQuads(*grid, surface);
  addField(*grid, "displacement [m]", snapshot.displacement, 3);
  addField(*grid, "travel and turn [m]", rolledBy(surface, snapshot), 3);
  addField(*grid, "von Mises stress [Pa]", snapshot.vonMises, 1);
  addField(*grid, "plastic strain", snapshot.plasticStrain, 1);
  return grid;
}

bool knowsTraction(const results::PatchSnapshot& contact) {
  const auto count = contact.x.size();
  return contact.tractionX.size() == count && contact.tractionY.size() == count && contact.slipping.size() == count;
}

// Quads that share no points, behind those that are there.
void addFaces(vtkCellArray& quads, vtkPoints& points, vtkPolyData& faces) {
  for (vtkIdType i = 0; i < faces.GetNumberOfPoints(); ++i) {
    if (i % 4 == 0) quads.InsertNextCell(4);
    quads.InsertCellPoint(points.InsertNextPoint(faces.GetPoint(i)));
  }
}

// The contacts of all sides.
Grid patchGrid(const results::PatchSnapshot& patch, const results::SurfaceMesh& surface,
               const results::SurfaceSnapshot& snapshot) {
  const auto parts = partData(surface, &snapshot, Field::none, 1.0);
  const double contactAt = wheelCentre(surface)[0] + snapshot.wheelTravel;
  const auto contacts = contactsInPlace(patch, surface);
  const bool known = std::all_of(contacts.begin(), contacts.end(), knowsTraction);
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkFloatArray> pressure, traction;
  vtkNew<vtkUnsignedCharArray> slipping;
  pressure->SetName("contact pressure [Pa]");
  traction->SetName("traction [Pa]");
  traction->SetNumberOfComponents(3);
  slipping->SetName("slipping");
  for (const auto& contact : contacts) {
    const auto pressed = patchFaces(contact, parts, contactAt, 0);
    addFaces(*quads, *points, *pressed.faces);
    for (const std::size_t i : pressed.point) {
      pressure->InsertNextValue(contact.pressure[i]);
      if (!known) continue;
      traction->InsertNextTuple3(static_cast<double>(contact.tractionX[i]), static_cast<double>(contact.tractionY[i]),
                                 0);
      slipping->InsertNextValue(contact.slipping[i]);
    }
  }
  grid->SetPoints(points);
  grid->SetCells(VTK_QUAD, quads);
  grid->GetCellData()->AddArray(pressure);
  if (!known) return grid;
  grid->GetCellData()->AddArray(traction);
  grid->GetCellData()->AddArray(slipping);
  return grid;
}

// The impact is often one of the frames: one of them is enough.
bool isRepeated(const std::vector<results::SurfaceSnapshot>& snapshots, std::size_t i) {
  const auto same = [&](const auto& other) { return other.time == snapshots[i].time && other.name != "unloaded"; };
  return snapshots[i].name != "unloaded" &&
         std::any_of(snapshots.begin(), snapshots.begin() + static_cast<long>(i), same);
}

}  // namespace

std::vector<std::string> writeVtkSeries(const results::RunResult& result, const std::string& folder) {
  if (result.surface.quads.empty() || result.snapshots.empty())
    throw FileError(folder, "", "nothing to write: the result has no surface or no snapshots");
  const std::string stem = analysis::safeFileName(result.stem);  // may be untrusted
  VtkCollection collection(folder, stem);
  for (std::size_t i = 0; i < result.snapshots.size(); ++i) {
    const auto& snapshot = result.snapshots[i];
    if (isRepeated(result.snapshots, i)) continue;
    collection.add(surfaceGrid(result.surface, snapshot), snapshot.time, 0, numberedName(stem, i));
    if (const auto* patch = patchOf(result, snapshot.name))
      collection.add(patchGrid(*patch, result.surface, snapshot), snapshot.time, 1, numberedName(stem + "_patch", i));
  }
  return collection.finish();
}

}  // namespace squat::scene
