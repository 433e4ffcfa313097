// solver/loggers/TdmsFile.h - TDMS files of National Instruments (LabVIEW, DIAdem, FlexLogger), versions 1.0 and 2.0.
#pragma once

#include <string>
#include <string_view>

#include "loggers/LoggerTable.h"

namespace squat::loggers {

bool isTdmsFile(std::string_view head);  // its first four bytes

// The channels of one group, scaled, as columns named after them. `object`: the name of the group; empty: that whose
// channels are longest. Its longest channels count, and of these the most that have one rate (wf_increment) or state
// none; what differs from them and what is no number is left out with a note. Time stamps become seconds since the
// first one, whose date is noted. Not a number and infinity become not-a-number, as in a table of text. Throws
// FileError for a damaged file, one that is cut off, one without such channels, and above 2^30 values.
LoggerTable parseTdms(std::string_view bytes, const std::string& path, const std::string& object);
LoggerTable readTdmsFile(const std::string& path, const std::string& object);  // at most 4 GB

}  // namespace squat::loggers
