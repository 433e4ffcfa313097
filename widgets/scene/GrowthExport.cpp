#include "scene/GrowthExport.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include "analysis/AnalysisFiles.h"
#include "growth/Grow.h"
#include "scene/VtkCollection.h"

namespace squat::scene {

namespace {

vtkSmartPointer<vtkUnstructuredGrid> stageGrid(const growth::SurfaceSeries& series, std::size_t stage) {
  const auto lines = series.y.size();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> height, change;
  height->SetName("height [m]"), change->SetName("change [m]");
  for (std::size_t s = 0; s < series.x.size(); ++s)
    for (std::size_t line = 0; line < lines; ++line) {
      const float now = series.height[stage][s * lines + line];
      points->InsertNextPoint(series.x[s], series.y[line], static_cast<double>(now));
      height->InsertNextValue(now), change->InsertNextValue(now - series.height.front()[s * lines + line]);
    }
  grid->SetPoints(points);
  for (std::size_t s = 0; s + 1 < series.x.size(); ++s)
    for (std::size_t line = 0; line + 1 < lines; ++line) {
      const auto at = [&](std::size_t ds, std::size_t dl) {
        return static_cast<vtkIdType>(s + ds) * static_cast<vtkIdType>(lines) + static_cast<vtkIdType>(line + dl);
      };
      const vtkIdType corners[4] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
      grid->InsertNextCell(VTK_QUAD, 4, corners);
    }
  grid->GetPointData()->AddArray(height);
  grid->GetPointData()->AddArray(change);
  return grid;
}

}  // namespace

std::vector<std::string> writeGrowthSeries(const growth::SurfaceSeries& series, const std::string& stem,
                                           const std::string& folder) {
  const std::string name = analysis::safeFileName(stem);
  VtkCollection collection(folder, name);
  double last = -1;
  for (std::size_t stage = 0; stage < series.tonnage.size(); ++stage) {
    double time = series.tonnage[stage] / growth::kilogramsInMegatonne;
    if (time <= last) time = last * (1 + growth::tonnageRounding);  // the rail has been ground: two grids, not one
    collection.add(stageGrid(series, stage), time, 0, numberedName(name, stage));
    last = time;
  }
  return collection.finish();
}

}  // namespace squat::scene
