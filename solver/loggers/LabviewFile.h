// solver/loggers/LabviewFile.h - LabVIEW's text files of measurements (.lvm).
#pragma once

#include <string>
#include <string_view>

#include "loggers/LoggerTable.h"

namespace squat::loggers {

// Whether a file that begins with `head` is one: its first words say so.
bool isLabviewFile(std::string_view head);

// Segments of the same channels follow on. Without X columns the rate is that of Delta_X; with X columns the first
// column is "time" [s] where X_Dimension says Time, else "X_Value". LabVIEW writes X with six decimals: where it is
// X0 + i Delta_X but for this rounding, the exact value stands in the column. Channels of another rate or another X
// than most are left out, with a note. An empty field is not-a-number. Throws FileError with the line: no channels,
// names that do not fit the number of channels, no rows, a header that does not end. Limit: 4 GB.
LoggerTable readLabviewFile(const std::string& path);

// The same for a file in memory; `path` is for messages.
LoggerTable parseLabviewFile(std::string_view bytes, const std::string& path);

}  // namespace squat::loggers
