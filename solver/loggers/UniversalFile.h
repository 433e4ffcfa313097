// solver/loggers/UniversalFile.h - functions in universal files (.unv, .uff), as programs for modal tests write them.
#pragma once

#include <string>
#include <string_view>

#include "loggers/LoggerTable.h"

namespace squat::loggers {

// Whether a file that begins with `head` is one: a line "    -1", then the number of a dataset.
bool isUniversalFile(std::string_view head);

// Reads datasets 58 (text) and 58b (IEEE 754, both orders of bytes); dataset 164 states the units of those that follow.
// Time histories (types 1 and 0) where there are any: one column each, with the rate, or with a column "time" [s] where
// the abscissa is uneven. Else frequency responses (type 4): a column "f" [Hz], then for each response "NAME Re" and
// "NAME Im", without the name where there is one only. Functions over another abscissa than most are left out, with a
// note.
//
// Names: ID line 1, or point and direction ("12 +Z") where that is empty or not unique. Units: the label, else SI by
// the code of the quantity, with the values converted by dataset 164; of a response those of its numerator over its
// denominator ("m/s2/N"). Six digits of the increment leave the rate open in its sixth digit: then it is taken to be
// the round number that they allow, with a note.
//
// Throws FileError with the line or dataset: nothing of these kinds, DEC or IBM numbers, a damaged dataset. A last
// dataset that is cut short is left out with a note where others are whole. Limit: 4 GB.
LoggerTable readUniversalFile(const std::string& path);

// The same for a file in memory; `path` is for messages.
LoggerTable parseUniversalFile(std::string_view bytes, const std::string& path);

}  // namespace squat::loggers
