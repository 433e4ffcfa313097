// Measured signals (tables of any layout, HDF5, MATLAB): any bytes give signals with positions that rise, or an error
// of ours. Array files are read in a child process, whose death is an error too.
#include <cmath>

#include "MemoryFile.h"
#include "core/Errors.h"
#include "readers/SignalFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  squat::readers::SignalFileOptions options;
  options.column = "all";
  options.speed = 30;
  try {
    for (const auto& signal : squat::readers::readSignals(squat::tests::memoryFile(data, size), options)) {
      if (!(squat::signals::seriesOf(signal).step > 0) || signal.signals[0].values.size() < 2) std::abort();
      for (const double value : signal.signals[0].values)
        if (!std::isfinite(value)) std::abort();
      for (std::size_t i = 1; i < signal.position.size(); ++i)
        if (!(signal.position[i] > signal.position[i - 1])) std::abort();
    }
  } catch (const squat::FileError&) {
  } catch (const squat::CaseError&) {
  }
  return 0;
}
