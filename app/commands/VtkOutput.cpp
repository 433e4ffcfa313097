#include "commands/VtkOutput.h"

#include "scene/VtkExport.h"

namespace squat::commands {

std::vector<std::string> writeVtkFiles(const results::RunResult& result, const std::string& folder) {
  return scene::writeVtkSeries(result, folder);
}

}  // namespace squat::commands
