// Lists of events (squats.json): any text gives events whose numbers are finite and whose counts fit, or an error of
// ours.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/Errors.h"
#include "project/EventList.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    for (const auto& event : project::parseEventList({reinterpret_cast<const char*>(data), size}, "squats.json").events)
      if (!std::isfinite(event.position) || !std::isfinite(event.time) || !std::isfinite(event.peak) ||
          event.passes < 0 || event.passesThere < 0 || !(event.length >= 0) || !(event.depth >= 0))
        std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
