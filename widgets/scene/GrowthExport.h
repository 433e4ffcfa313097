// widgets/scene/GrowthExport.h - a growing rail surface for other programs, ParaView above all.
#pragma once

#include <string>
#include <vector>

#include "growth/SurfaceSeries.h"

namespace squat::scene {

// Writes into `folder`, each file durably:
//   STEM_000.vtu ...  one a stage: the running surface with its points in their places [m], "height [m]", and "change
//                     [m]" since the first stage. Heights are in metres and some micrometres large: "Warp By
//                     Scalar" makes them visible.
//   STEM.pvd          links them to their tonnages [Mt], which stand in the place of time
// Returns the files, STEM.pvd last. Needs no OpenGL. Throws FileError.
std::vector<std::string> writeGrowthSeries(const growth::SurfaceSeries& series, const std::string& stem,
                                           const std::string& folder);

}  // namespace squat::scene
