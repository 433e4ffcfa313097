// solver/project/ViewsInFile.h - the part of a project file that says how figures and tables are shown.
#pragma once

#include <nlohmann/json.hpp>

#include "project/JsonNode.h"
#include "project/Project.h"

namespace squat::project {

nlohmann::ordered_json jsonOf(const FigureViews& figures);  // "ranges" where there are some
nlohmann::ordered_json jsonOf(const TableOrder& order);

// These throw FileError with the location: where something is missing, of another kind or out of range, and where the
// lower end of a range is not below the upper one. Names are taken as they are: what this version does not know is
// shown as it usually is.
FigureViews figuresIn(const JsonNode& node);
TableOrder orderIn(const JsonNode& node);

}  // namespace squat::project
