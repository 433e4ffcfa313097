// solver/scenario/DefectZone.h - the stretch of rail that is meshed finely for a defect of rail or wheel.
#pragma once

#include <algorithm>

#include "scenario/DefectSurface.h"
#include "scenario/MeshSizes.h"
#include "scenario/TreadDeviation.h"

namespace squat::scenario {

// Distances from the deepest point of the defect, both positive.
struct DefectZone {
  double before = 0, behind = 0;  // [m]
  bool operator==(const DefectZone&) const = default;
};

// What the mesh is made for: the defect itself, or any one that lies within mesh.zone_before and mesh.zone_behind, and
// a flat of the wheel where it meets the rail.
inline DefectZone defectZone(const DefectSurface& surface, const TreadDeviation& tread, const MeshSizes& mesh) {
  DefectZone zone{std::max(-surface.first(), mesh.zoneBefore), std::max(surface.last(), mesh.zoneBehind)};
  if (tread.isLocal()) {
    zone.before = std::max(zone.before, tread.dipBefore() - tread.position());
    zone.behind = std::max(zone.behind, tread.dipBehind() + tread.position());
  }
  return zone;
}

}  // namespace squat::scenario
