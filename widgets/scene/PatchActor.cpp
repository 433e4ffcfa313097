#include "scene/PatchActor.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "colours/ColourTables.h"
#include "results/PatchCells.h"

namespace squat::scene {
namespace {

constexpr double lift = 3e-5;    // [m] above the rail, so that the rail does not shine through
constexpr double reach = 0.03;   // [m] of the rail's points that are looked at
constexpr double topOf = -0.01;  // [m] below the top of the rail they count no more

// Points of the rail's running surface near the contact.
std::vector<std::array<double, 3>> runningSurface(const std::vector<PartData>& parts, double contactAt) {
  std::vector<std::array<double, 3>> near;
  for (const auto& part : parts) {
    if (part.name != "rail") continue;
    for (vtkIdType i = 0; i < part.faces->GetNumberOfPoints(); ++i) {
      const double* p = part.faces->GetPoint(i);
      if (std::abs(p[0] - contactAt) < reach && std::abs(p[1]) < reach && p[2] > topOf)
        near.push_back({p[0], p[1], p[2]});
    }
  }
  return near;
}

// Mean of the four nearest points, weighted by the inverse of their distance.
double heightAt(const std::vector<std::array<double, 3>>& surface, double x, double y) {
  std::vector<std::pair<double, double>> nearest;
  for (const auto& p : surface) nearest.emplace_back(std::hypot(p[0] - x, p[1] - y), p[2]);
  const std::size_t count = std::min<std::size_t>(4, nearest.size());
  if (count == 0) return 0;
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end());
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = 1 / (1e-6 + nearest[i].first);
    sum += weight * nearest[i].second;
    weights += weight;
  }
  return sum / weights;
}

std::array<double, 3> colourOf(const results::PatchSnapshot& patch, std::size_t i, const Look& look) {
  if (look.field == Field::stickSlip) return i < patch.slipping.size() && patch.slipping[i] ? slipColour : stickColour;
  const double share = (1e-6 * static_cast<double>(patch.pressure[i]) - look.low) / (look.high - look.low);
  const colours::Rgb colour = colours::colourAt(look.colourMap, share);
  return {colour.red, colour.green, colour.blue};
}

}  // namespace

const results::PatchSnapshot* patchOf(const results::RunResult& result, const std::string& snapshotName) {
  for (const auto& patch : result.patches)
    if (patch.name == snapshotName && patch.x.size() == patch.pressure.size() && patch.y.size() == patch.x.size())
      return &patch;
  return nullptr;
}

double largestPressure(const results::PatchSnapshot& patch) {
  double largest = 0;
  for (const float pressure : patch.pressure)
    if (std::isfinite(pressure)) largest = std::max(largest, 1e-6 * static_cast<double>(pressure));
  return largest;
}

vtkSmartPointer<vtkActor> patchActor(const results::PatchSnapshot& patch, const std::vector<PartData>& parts,
                                     double contactAt, const Look& look) {
  const auto surface = runningSurface(parts, contactAt);
  const auto cells = results::patchCells(patch);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> boxes;
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!(patch.pressure[i] > 0)) continue;
    const double x = contactAt + static_cast<double>(patch.x[i]), y = static_cast<double>(patch.y[i]);
    const double z = heightAt(surface, x, y) + lift;
    const results::PatchCell& cell = cells[i];
    boxes->InsertNextCell(4);
    for (const auto& [along, across] :
         {std::pair{cell.left, cell.near}, {cell.right, cell.near}, {cell.right, cell.far}, {cell.left, cell.far}})
      boxes->InsertCellPoint(points->InsertNextPoint(contactAt + along, across, z));
    const auto colour = colourOf(patch, i, look);
    unsigned char bytes[3];
    for (std::size_t channel = 0; channel < 3; ++channel)
      bytes[channel] = static_cast<unsigned char>(std::lround(255 * colour[channel]));
    shades->InsertNextTypedTuple(bytes);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(boxes);
  data->GetCellData()->SetScalars(shades);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarModeToUseCellData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(false);
  return actor;
}

}  // namespace squat::scene
