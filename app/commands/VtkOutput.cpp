#include "commands/VtkOutput.h"

#include "scene/GrowthExport.h"
#include "scene/VtkExport.h"

namespace squat::commands {

std::vector<std::string> writeVtkFiles(const results::RunResult& result, const std::string& folder) {
  return scene::writeVtkSeries(result, folder);
}

std::vector<std::string> writeVtkFiles(const growth::SurfaceSeries& series, const std::string& stem,
                                       const std::string& folder) {
  return scene::writeGrowthSeries(series, stem, folder);
}

}  // namespace squat::commands
