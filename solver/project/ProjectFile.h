// solver/project/ProjectFile.h - the project file STEM.squat-project: JSON, with links to the files of runs, signals
// and records.
#pragma once

#include <string>

#include "project/Project.h"

namespace squat::project {

// Raise it when an old reader would misread a new file. 2: measured signals with a gain; 3: long records, which an
// older program would drop when it saves. A file that holds neither is still written as 1. What figures and tables look
// like (`figures`, `run_order`, `records/order`) raises nothing: an older program shows its own defaults. Nor do
// digests of records (`records/digests`): an older program notices no change; and which channels are axle boxes
// (`records/axles`): an older program tells no sides.
inline constexpr int projectSchema = 3;

// The text of a project whose file stands in `folder`: links are relative where both share more than the root, so that
// a folder with all of them can be moved.
std::string projectText(const Project& project, const std::string& folder);

// The other way. `origin` names the text in messages. Throws FileError with line or key ("/runs/3/path") where it is no
// JSON, something is missing, of a wrong kind or out of range, the open case is none, or the schema is newer.
Project parseProject(const std::string& text, const std::string& origin, const std::string& folder);

// Written durably and read back before it replaces what stood there. Throws FileError.
void writeProject(const std::string& path, const Project& project);

// At most 64 MB. Opens no other file. Throws FileError.
Project readProject(const std::string& path);

}  // namespace squat::project
