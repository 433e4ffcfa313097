// solver/loggers/WavFile.h - waves in RIFF files (.wav), as sound recorders and some loggers write them.
#pragma once

#include <string>
#include <string_view>

#include "loggers/LoggerTable.h"

namespace squat::loggers {

// Whether a file that begins with `head` is one: RIFF, RF64 or BW64 of the form WAVE.
bool isWavFile(std::string_view head);

// Columns "channel 1", "channel 2", ... Whole numbers of 8, 16, 24 and 32 bits as parts of full scale, -1 to 1;
// floating point of 32 and 64 bits as it stands. Where the comment (ICMT) or the description (bext) names one
// calibration, such as "full scale 500 m/s2", "FS=50 g" or "1.0 = 500 m/s2", the values are in its unit; else without
// unit, and a note says so. A file that ends early is read to its end, with a note. Throws FileError with the chunk: no
// format, a compressed one, no samples. Limit: 4 GB.
LoggerTable readWavFile(const std::string& path);

// The same for a file in memory; `path` is for messages.
LoggerTable parseWavFile(std::string_view bytes, const std::string& path);

}  // namespace squat::loggers
