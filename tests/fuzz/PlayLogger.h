// Files of measuring programs: any bytes give columns of one length under a usable rate, or an error of ours; the check
// of a file's head gets it cut anywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/Errors.h"
#include "loggers/LoggerTable.h"

namespace squat::tests {

inline int playLogger(loggers::LoggerTable (*parse)(std::string_view, const std::string&),
                      bool (*isOfTheFormat)(std::string_view), const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  (void)isOfTheFormat(bytes);
  try {
    const auto read = parse(bytes, "fuzz");
    if (!std::isfinite(read.rate) || read.rate < 0 || read.table.columns.empty()) std::abort();
    for (const auto& column : read.table.columns) {
      if (column.values.size() != read.table.rows()) std::abort();
      for (const double value : column.values)
        if (std::isinf(value)) std::abort();
    }
  } catch (const FileError&) {
  }
  return 0;
}

}  // namespace squat::tests
