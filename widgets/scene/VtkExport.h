// widgets/scene/VtkExport.h - the surface, the contact patch and their fields for other programs, ParaView above all.
#pragma once

#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::scene {

// Writes into `folder`, each file durably:
//   STEM_000.vtu ...        one a stored instant: the quads of the surface with every point in its place then (rolled,
//                           travelled and displaced), "displacement [m]" (without travel and turn), "travel and turn
//                           [m]" (from the place at the start), "von Mises stress [Pa]", "plastic strain" where the
//                           rail may yield, per quad "part"; field data "part names"
//   STEM_patch_000.vtu ...  one an instant whose contact patch is stored: a quad for each point under pressure, of a
//                           whole model on both rails, with "contact pressure [Pa]", "traction [Pa]" on the rail,
//                           "slipping"
//   STEM.pvd                links both to their times [s]; an instant that is stored under two names stands there once
// Returns the files, STEM.pvd last. Needs no OpenGL. Throws FileError, also for a result without surface or snapshots.
std::vector<std::string> writeVtkSeries(const results::RunResult& result, const std::string& folder);

}  // namespace squat::scene
