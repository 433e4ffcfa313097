// solver/loggers/GzipText.h - files packed with gzip.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace squat::loggers {

bool isGzip(std::string_view head);  // its first two bytes

// All members of a packed file, one behind the other (as `cat a.gz b.gz` makes them), each checked against its sum.
// Zeros that fill the last block of a tape or disc are passed over, as gzip does. Throws FileError for what is damaged,
// cut off, or followed by anything else, and for more than `maximum` bytes, before they are held in memory.
std::string unpacked(std::string_view bytes, const std::string& path, std::size_t maximum);

}  // namespace squat::loggers
