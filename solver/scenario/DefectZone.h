// solver/scenario/DefectZone.h - the stretch of rail that is meshed finely for a defect.
#pragma once

#include <algorithm>

#include "scenario/DefectSurface.h"
#include "scenario/MeshSizes.h"

namespace squat::scenario {

// Distances from the deepest point of the defect, both positive.
struct DefectZone {
  double before = 0, behind = 0;  // [m]
  bool operator==(const DefectZone&) const = default;
};

// What the mesh is made for: the defect itself, or any one that lies within mesh.zone_before and mesh.zone_behind.
inline DefectZone defectZone(const DefectSurface& surface, const MeshSizes& mesh) {
  return {std::max(-surface.first(), mesh.zoneBefore), std::max(surface.last(), mesh.zoneBehind)};
}

}  // namespace squat::scenario
