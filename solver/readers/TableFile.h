// solver/readers/TableFile.h - any file that is one table, whatever wrote it: text, packed text, files of measuring
// programs.
#pragma once

#include <string>

#include "loggers/LoggerTable.h"
#include "readers/SignalFile.h"

namespace squat::readers {

// Columns as the file names them, before units that the call states; the rate where the file has one beside them.
// Throws FileError.
loggers::LoggerTable readTableFile(const std::string& path, const SignalFileOptions& options = {});

}  // namespace squat::readers
