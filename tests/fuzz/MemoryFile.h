// A file in memory that holds what the fuzzer made, for readers that take a path.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace squat::tests {

inline std::string memoryFile(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("fuzz.csv", 0);
  if (file < 0 || ::ftruncate(file, 0) != 0) std::abort();
  if (::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  return "/proc/self/fd/" + std::to_string(file);
}

}  // namespace squat::tests
