#include "studio/tools/ToolForm.h"

#include <filesystem>

#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::studio {

std::string keepCase(const ToolInput& input, const std::string& table) {
  const std::string folder = input.folder + "/case";
  std::string path = folder + "/" + input.name + ".toml";
  if (!table.empty() && std::filesystem::exists(table) &&
      !(std::filesystem::exists(path) && cases::caseHash(cases::readCase(path)) == cases::caseHash(input.description)))
    throw CaseError({{"folder", input.folder, "a folder without results of another case",
                      "choose another folder, or open the case that made " + table}});
  makeFolder(folder);
  cases::saveCase(input.description, path);
  return path;
}

}  // namespace squat::studio
