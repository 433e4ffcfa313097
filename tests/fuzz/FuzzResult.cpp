// Result files (HDF5): any bytes give a result or a FileError, whatever they do to the HDF5 library in the child.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/Errors.h"
#include "results/ResultFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("fuzz.h5", 0);
  if (file < 0 || ::ftruncate(file, 0) != 0) std::abort();
  if (::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  try {
    squat::results::readResult("/proc/self/fd/" + std::to_string(file));
  } catch (const squat::FileError&) {
  }
  return 0;
}
