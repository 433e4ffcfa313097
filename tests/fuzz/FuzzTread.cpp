// Lines of a wheel's tread: any text gives finite points at places that rise, or an error of ours.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "case/TreadFile.h"
#include "core/Errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    for (const auto& line : cases::parseTreadLines({reinterpret_cast<const char*>(data), size}, "fuzz.csv", 0.46))
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        if (!std::isfinite(line.points[i].position) || !std::isfinite(line.points[i].height)) std::abort();
        if (i > 0 && !(line.points[i].position > line.points[i - 1].position)) std::abort();
      }
  } catch (const FileError&) {
  }
  return 0;
}
