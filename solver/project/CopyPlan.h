// solver/project/CopyPlan.h - which file goes where when a project is copied with its data.
#pragma once

#include <string>
#include <vector>

#include "project/Project.h"

namespace squat::project {

struct PlannedFile {
  std::string from;
  std::string to;    // relative to the folder of the data
  std::string text;  // what the copy holds; empty: what the file holds
};

struct CopyPlan {
  Project project;                    // its links lead into the folder of the data
  std::vector<PlannedFile> files;     // each once
  std::vector<std::string> problems;  // a sentence for each file that is missing: its link stays as it is
};

// Results go into "runs", measured signals into "signals", long records and labels into "records", lists of events with
// their passages into "events", cases with the profiles that they name into "cases". Every file keeps its name; where
// two have the same, the second goes into a subfolder "2". A profile keeps its location relative to its case; one that
// the case names by its full path goes beside the case, which then names it without the path. Looks at files, writes
// none. `folder`: of the data, absolute.
CopyPlan planCopy(const Project& project, const std::string& folder);

}  // namespace squat::project
