// tests/gui/LinkedProject.h - a project of many runs that are one file.
#pragma once

#include <filesystem>
#include <string>

#include "project/ProjectFile.h"

namespace squat::tests {

// FOLDER/run-N.h5; the first one has to be there.
inline std::string runFile(const std::string& folder, int run) {
  return folder + "/run-" + std::to_string(run) + ".h5";
}

// Hard links make `count` files of the first one; FOLDER/many.squat-project lists them as "run N", the last one in
// front, the first one the reference. Returns the project's path.
inline std::string writeLinkedProject(const std::string& folder, int count) {
  project::Project project;
  project.open.name = "dip";
  for (int run = 0; run < count; ++run) {
    if (run > 0) {
      std::filesystem::remove(runFile(folder, run));
      std::filesystem::create_hard_link(runFile(folder, 0), runFile(folder, run));
    }
    project::Entry entry;
    entry.path = runFile(folder, run);
    entry.name = "run " + std::to_string(run);
    project.entries.push_back(entry);
  }
  project.current = count - 1;
  project.reference = 0;
  project::writeProject(folder + "/many.squat-project", project);
  return folder + "/many.squat-project";
}

}  // namespace squat::tests
