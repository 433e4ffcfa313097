#include "studio/preview/PreviewStart.h"

#include <algorithm>
#include <cmath>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"

namespace squat::studio {
namespace {

constexpr double nearStep = 0.005;  // [m]: a slider that lengthens the defect needs another state now and then only
constexpr double roundOff = 1e-9;
constexpr std::size_t meshesKept = 4;  // about 9 MB each

// Where the defect begins, in steps [m].
double beforeOf(const cases::CaseDescription& description) {
  const double own = -cases::surfaceOf(description).first();
  return nearStep * std::ceil(own / nearStep - roundOff);
}

}  // namespace

bool isOnMeshOf(const simulation::WarmState& state, const cases::CaseDescription& description) {
  return cases::defectZone(state.description) == cases::defectZone(description) && simulation::fits(state, description);
}

bool PreviewStart::serves(const cases::CaseDescription& description) const {
  return std::any_of(meshes_.begin(), meshes_.end(),
                     [&](const OfOneMesh& mesh) { return isOnMeshOf(*mesh.first, description); });
}

bool PreviewStart::bringToFront(const cases::CaseDescription& description) {
  const auto found = std::find_if(meshes_.begin(), meshes_.end(),
                                  [&](const OfOneMesh& mesh) { return isOnMeshOf(*mesh.first, description); });
  if (found == meshes_.end()) return false;
  std::rotate(meshes_.begin(), found, found + 1);
  return true;
}

PreviewStart::State PreviewStart::stateFor(const cases::CaseDescription& description, Monitor& monitor) {
  if (!bringToFront(description)) {
    auto made = solver_.makeStart(description, options_, monitor);
    if (!made) return nullptr;
    if (meshes_.size() == meshesKept) meshes_.pop_back();
    meshes_.insert(meshes_.begin(), {std::make_shared<const simulation::WarmState>(*std::move(made)), nullptr, 0});
  }
  return rolledOn(meshes_.front(), description, monitor);
}

PreviewStart::State PreviewStart::rolledOn(OfOneMesh& mesh, const cases::CaseDescription& description,
                                           Monitor& monitor) {
  const double before = beforeOf(description);
  if (before + nearStep > cases::defectZone(description).before) return mesh.first;
  if (mesh.near && before <= mesh.nearBefore + roundOff) return mesh.near;
  mesh.near.reset();
  try {
    auto made = solver_.rollOn(mesh.first, description, before, options_, monitor);
    if (!made) return nullptr;
    mesh.near = std::make_shared<const simulation::WarmState>(*std::move(made));
    mesh.nearBefore = before;
  } catch (const RunError&) {  // a profile that rises so high that the wheel touches it earlier
    return mesh.first;
  }
  return mesh.near;
}

}  // namespace squat::studio
