// Labels of events, cell by cell: any bytes give finite positions, or an error of ours.
#include <cmath>

#include "MemoryFile.h"
#include "core/Errors.h"
#include "detection/DetectionFiles.h"
#include "detection/Label.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    for (const auto& label : detection::readLabels(tests::memoryFile(data, size)))
      if (!std::isfinite(label.position)) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
