// TDMS files: any bytes give columns of one length whose bad values are not-a-number, or an error of ours.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/Errors.h"
#include "loggers/TdmsFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto read =
        squat::loggers::parseTdms(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.tdms", "");
    if (read.table.columns.empty() || read.table.rows() == 0) std::abort();
    if (!std::isfinite(read.rate) || read.rate < 0) std::abort();
    for (const auto& column : read.table.columns) {
      if (column.values.size() != read.table.rows()) std::abort();
      for (const double value : column.values)
        if (std::isinf(value)) std::abort();
    }
  } catch (const squat::FileError&) {
  }
  return 0;
}
