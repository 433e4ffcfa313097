// Project files (JSON): any text gives a project that is written and read back the same, or an error of ours.
#include <cstdint>
#include <cstdlib>

#include "core/Errors.h"
#include "project/ProjectFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    const std::string folder = "/projects";
    const auto read = project::parseProject({reinterpret_cast<const char*>(data), size}, "fuzz.squat-project", folder);
    const auto text = project::projectText(read, folder);
    if (project::projectText(project::parseProject(text, "fuzz.squat-project", folder), folder) != text) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
