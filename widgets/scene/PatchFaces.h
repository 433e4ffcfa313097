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

struct PatchFaces {
  vtkSmartPointer<vtkPolyData> faces;  // one quad a point under pressure, on the rail and `lift` above it [m]
  std::vector<std::size_t> point;      // of each quad: its point of the patch
};

// `parts` hold the rail where it is at that instant, `contactAt` is the place of the wheel centre along it [m].
PatchFaces patchFaces(const results::PatchSnapshot& patch, const std::vector<PartData>& parts, double contactAt,
                      double lift);

}  // namespace squat::scene
