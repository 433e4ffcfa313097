// widgets/scene/VtkExport.h - the surface and its fields for other programs.
#pragma once

#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::scene {

// Writes STEM_000.vtu ... (one a snapshot, in its place and with displacement [m], von Mises stress [Pa], plastic
// strain and the number of the part) and STEM.pvd, which links them to their times, into `folder`. Returns the files.
// Needs no OpenGL. Throws FileError, also for a result without surface or snapshots.
std::vector<std::string> writeVtkSeries(const results::RunResult& result, const std::string& folder);

}  // namespace squat::scene
