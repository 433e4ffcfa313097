// Measured signals (tables of any layout, HDF5, MATLAB): any bytes give signals with positions that rise, or an error
// of ours. Array files are read in a child process, whose death is an error too.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/Errors.h"
#include "readers/SignalFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("fuzz.csv", 0);
  if (file < 0 || ::ftruncate(file, 0) != 0) std::abort();
  if (::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  squat::readers::SignalFileOptions options;
  options.column = "all";
  options.speed = 30;
  try {
    for (const auto& signal : squat::readers::readSignals("/proc/self/fd/" + std::to_string(file), options)) {
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
