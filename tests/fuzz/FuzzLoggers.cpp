// Files of measuring programs: any bytes give columns of one length under a usable rate, or an error of ours.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/Errors.h"
#include "loggers/LabviewFile.h"
#include "loggers/SeismicList.h"
#include "loggers/UniversalFile.h"
#include "loggers/WavFile.h"

namespace {

void play(squat::loggers::LoggerTable (*parse)(std::string_view, const std::string&), std::string_view bytes) {
  try {
    const auto read = parse(bytes, "fuzz");
    if (!std::isfinite(read.rate) || read.rate < 0 || read.table.columns.empty()) std::abort();
    for (const auto& column : read.table.columns) {
      if (column.values.size() != read.table.rows()) std::abort();
      for (const double value : column.values)
        if (std::isinf(value)) std::abort();
    }
  } catch (const squat::FileError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  play(squat::loggers::parseLabviewFile, bytes);
  play(squat::loggers::parseWavFile, bytes);
  play(squat::loggers::parseUniversalFile, bytes);
  play(squat::loggers::parseSeismicList, bytes);
  // The checks of a file's head get it cut anywhere.
  (void)squat::loggers::isLabviewFile(bytes);
  (void)squat::loggers::isWavFile(bytes);
  (void)squat::loggers::isUniversalFile(bytes);
  (void)squat::loggers::isSeismicList(bytes);
  return 0;
}
