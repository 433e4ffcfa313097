#include "scene/VtkExport.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "analysis/AnalysisFiles.h"
#include "core/Errors.h"
#include "scene/SurfaceData.h"

namespace squat::scene {
namespace {

void addField(vtkUnstructuredGrid& grid, const char* name, const std::vector<float>& values, int components) {
  if (values.size() != static_cast<std::size_t>(grid.GetNumberOfPoints() * components)) return;
  vtkNew<vtkFloatArray> field;
  field->SetName(name);
  field->SetNumberOfComponents(components);
  field->SetNumberOfTuples(grid.GetNumberOfPoints());
  std::copy(values.begin(), values.end(), field->GetPointer(0));
  grid.GetPointData()->AddArray(field);
}

vtkSmartPointer<vtkUnstructuredGrid> gridOf(const results::SurfaceMesh& surface,
                                            const results::SurfaceSnapshot& snapshot) {
  const std::vector<float> locations = locationsOf(surface, snapshot, 1.0);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  const auto count = static_cast<vtkIdType>(locations.size() / 3);
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i) points->SetPoint(i, &locations[static_cast<std::size_t>(3 * i)]);
  grid->SetPoints(points);
  vtkNew<vtkUnsignedCharArray> part;
  part->SetName("part");
  for (std::size_t quad = 0; quad < surface.part.size() && 4 * quad + 3 < surface.quads.size(); ++quad) {
    vtkIdType corners[4];
    bool valid = true;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      corners[corner] = surface.quads[4 * quad + corner];
      valid = valid && corners[corner] >= 0 && corners[corner] < count;
    }
    if (!valid) continue;
    grid->InsertNextCell(VTK_QUAD, 4, corners);
    part->InsertNextValue(surface.part[quad]);
  }
  grid->GetCellData()->AddArray(part);
  addField(*grid, "displacement [m]", snapshot.displacement, 3);
  addField(*grid, "von Mises stress [Pa]", snapshot.vonMises, 1);
  addField(*grid, "plastic strain", snapshot.plasticStrain, 1);
  return grid;
}

}  // namespace

std::vector<std::string> writeVtkSeries(const results::RunResult& result, const std::string& folder) {
  if (result.surface.quads.empty() || result.snapshots.empty())
    throw FileError(folder, "", "nothing to write: the result has no surface or no snapshots");
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  const std::filesystem::path directory(folder);
  const std::string stem = analysis::safeFileName(result.stem);  // may come from a stranger
  std::vector<std::string> written;
  std::string collection = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t i = 0; i < result.snapshots.size(); ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "_%03zu.vtu", i);
    const std::string name = stem + number;
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    const std::string path = (directory / name).string();
    writer->SetFileName(path.c_str());
    writer->SetInputData(gridOf(result.surface, result.snapshots[i]));
    if (writer->Write() != 1)
      throw FileError(path, "", "cannot be written", "check the folder and the room on the disk");
    written.push_back(path);
    char time[40];
    std::snprintf(time, sizeof time, "%.9g", result.snapshots[i].time);
    collection += std::string("<DataSet timestep=\"") + time + "\" file=\"" + name + "\"/>\n";
  }
  collection += "</Collection>\n</VTKFile>\n";
  const std::string path = (directory / (stem + ".pvd")).string();
  std::ofstream file(path, std::ios::binary);
  file << collection;
  file.close();
  if (!file) throw FileError(path, "", "cannot be written");
  written.push_back(path);
  return written;
}

}  // namespace squat::scene
