// solver/records/PandasFrames.h - data frames that pandas has written into HDF5 (format fixed).
#pragma once

#include <optional>
#include <string>

#include "readers/ArraySignals.h"

namespace squat::records {

// The columns of the frame or series in `group` ("/df"); nothing where there is none.
std::optional<readers::ArrayColumns> pandasColumns(const std::string& path, const results::ArrayTree& tree,
                                                   const std::string& group);

// Groups that hold one.
std::vector<std::string> pandasGroups(const results::ArrayTree& tree);

}  // namespace squat::records
