// solver/project/ProjectCopy.h - a project together with the files that it links to.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "project/Project.h"

namespace squat::project {

struct ProjectCopy {
  bool complete = false;              // false: cancelled, and nothing is left of it
  std::size_t files = 0;              // of data
  std::vector<std::string> problems;  // a sentence for each file that is missing: its link stays as it is
};

// Where the data of a copy is: "DIR/STEM.data" for "DIR/STEM.squat-project".
std::string dataFolder(const std::string& path);

// Copies every file that the project links to into dataFolder(path) (CopyPlan.h), byte for byte, so that digests hold
// for the copies too, and then writes the project, whose links lead there. All of it is durable. While files are
// copied, the folder has another name, so that a full disk, a kill or a power cut leaves nothing at `path` but what was
// there before; what a killed process leaves beside it is removed by the next copy. `path`: absolute. Throws FileError
// where something cannot be read or written, where the folder exists, and where `path` is open in a window.
ProjectCopy copyWithData(const Project& project, const std::string& path, Monitor& monitor);

}  // namespace squat::project
