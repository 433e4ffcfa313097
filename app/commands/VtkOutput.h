// app/commands/VtkOutput.h - a result or a growth as files for ParaView; a headless build has no VTK and says so.
#pragma once

#include <string>
#include <vector>

#include "growth/SurfaceSeries.h"
#include "results/RunResult.h"

namespace squat::commands {

// Writes STEM.pvd with its .vtu files and returns the paths. Throws CaseError in a headless build, FileError where a
// file cannot be written or the result has no surface.
std::vector<std::string> writeVtkFiles(const results::RunResult& result, const std::string& folder);
std::vector<std::string> writeVtkFiles(const growth::SurfaceSeries& series, const std::string& stem,
                                       const std::string& folder);

}  // namespace squat::commands
