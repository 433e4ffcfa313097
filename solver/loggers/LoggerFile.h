// solver/loggers/LoggerFile.h - files of measuring programs, by what they begin with, whatever their names.
#pragma once

#include <string>

#include "loggers/LoggerTable.h"

namespace squat::loggers {

// TDMS, LabVIEW's .lvm, WAV, UFF 58 and SLIST.
bool isLoggerFile(const std::string& path);

// `object`: a group of a TDMS file; empty: the one with the longest channels. Throws FileError. The file is read whole:
// 4 GB at most.
LoggerTable readLoggerFile(const std::string& path, const std::string& object);

// Text that has been packed by gzip; empty where the file is not packed. Throws FileError for damaged data and for more
// than 4 GB of text.
bool isPacked(const std::string& path);
std::string unpackedText(const std::string& path);

}  // namespace squat::loggers
