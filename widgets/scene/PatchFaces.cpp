#include "scene/PatchFaces.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "results/PatchCells.h"

namespace squat::scene {
namespace {

constexpr double patchReach = 0.03;  // [m] of the rail's points that are looked at
constexpr double topOf = -0.01;      // [m] below the top of the rail they count no more

// Middle of the contact's points across the rail [m].
double middleOf(const results::PatchSnapshot& contact) {
  if (contact.y.empty()) return 0;
  const auto [low, high] = std::minmax_element(contact.y.begin(), contact.y.end());
  return 0.5 * static_cast<double>(*low + *high);
}

// Points of the rail's running surface near the contact, whose middle is at (contactAt, across).
std::vector<std::array<double, 3>> runningSurface(const std::vector<PartData>& parts, double contactAt, double across) {
  std::vector<std::array<double, 3>> near;
  for (const auto& part : parts) {
    if (part.name != "rail") continue;
    for (vtkIdType i = 0; i < part.faces->GetNumberOfPoints(); ++i) {
      const double* p = part.faces->GetPoint(i);
      if (std::abs(p[0] - contactAt) < patchReach && std::abs(p[1] - across) < patchReach && p[2] > topOf)
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

bool fitsTogether(const results::PatchSnapshot& contact) {
  return contact.x.size() == contact.pressure.size() && contact.y.size() == contact.x.size();
}

}  // namespace

const results::PatchSnapshot* patchOf(const results::RunResult& result, const std::string& snapshotName) {
  for (const auto& patch : result.patches)
    if (patch.name == snapshotName && fitsTogether(patch)) return &patch;
  return nullptr;
}

std::vector<results::PatchSnapshot> contactsInPlace(const results::PatchSnapshot& patch,
                                                    const results::SurfaceMesh& surface) {
  std::vector<results::PatchSnapshot> contacts{patch};
  if (!patch.right || !fitsTogether(*patch.right)) return contacts;
  auto& right = contacts.emplace_back(*patch.right);
  const auto mirror = static_cast<float>(2 * middleAcross(surface));
  for (float& y : right.y) y = mirror - y;
  for (float& traction : right.tractionY) traction = -traction;
  return contacts;
}

PatchFaces patchFaces(const results::PatchSnapshot& patch, const std::vector<PartData>& parts, double contactAt,
                      double lift) {
  const auto surface = runningSurface(parts, contactAt, middleOf(patch));
  const auto cells = results::patchCells(patch);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  PatchFaces found{vtkSmartPointer<vtkPolyData>::New(), {}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!(patch.pressure[i] > 0)) continue;
    const double x = contactAt + static_cast<double>(patch.x[i]), y = static_cast<double>(patch.y[i]);
    const double z = heightAt(surface, x, y) + lift;
    const results::PatchCell& cell = cells[i];
    quads->InsertNextCell(4);
    for (const auto& [along, across] :
         {std::pair{cell.left, cell.near}, {cell.right, cell.near}, {cell.right, cell.far}, {cell.left, cell.far}})
      quads->InsertCellPoint(points->InsertNextPoint(contactAt + along, across, z));
    found.point.push_back(i);
  }
  found.faces->SetPoints(points);
  found.faces->SetPolys(quads);
  return found;
}

}  // namespace squat::scene
