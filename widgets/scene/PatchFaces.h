// widgets/scene/PatchFaces.h - the contact patch as faces that lie on the rail's running surface.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "results/RunResult.h"
#include "scene/SurfaceData.h"

namespace squat::scene {

// The patch of a snapshot's instant; null where there is none whose lengths fit together.
const results::PatchSnapshot* patchOf(const results::RunResult& result, const std::string& snapshotName);

// Its contacts where they are on the surface, the left one first: y and traction_y of all count from the left rail's
// axis to the left. A right one whose lengths do not fit together is left out.
std::vector<results::PatchSnapshot> contactsInPlace(const results::PatchSnapshot& patch,
                                                    const results::SurfaceMesh& surface);

struct PatchFaces {
  vtkSmartPointer<vtkPolyData> faces;  // one quad a point under pressure, on the rail and `lift` above it [m]
  std::vector<std::size_t> point;      // of each quad: its point of the patch
};

// Of one contact in its place. `parts` hold the rail where it is at that instant, `contactAt` is the place of the wheel
// centre along it [m].
PatchFaces patchFaces(const results::PatchSnapshot& patch, const std::vector<PartData>& parts, double contactAt,
                      double lift);

}  // namespace squat::scene
