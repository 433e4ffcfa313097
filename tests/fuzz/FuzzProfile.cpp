// Profiles (CSV): any text gives ascending finite points or an error of ours.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "case/ProfileFile.h"
#include "core/Errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    const auto points = cases::parseProfile({reinterpret_cast<const char*>(data), size}, "fuzz.csv");
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!std::isfinite(points[i].position) || !std::isfinite(points[i].height)) std::abort();
      if (i > 0 && !(points[i].position > points[i - 1].position)) std::abort();
    }
  } catch (const FileError&) {
  }
  return 0;
}
