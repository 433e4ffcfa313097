// Reading with a child process between the file and us: whatever the file does to the HDF5 library, it does there.
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "results/ColumnPieces.h"
#include "results/Hdf5.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Reader.h"

namespace squat::results {

ArrayTree readOwnHdf5(const std::string& path, const Hdf5Limits& limits) {
  const auto lock = hdf5::lockLibrary();
  return hdf5::readTree(path, limits);
}

ArrayTree readHdf5(const std::string& path, const Hdf5Limits& limits) {
  std::error_code ignored;
  const auto fileBytes =
      std::filesystem::is_regular_file(path, ignored) ? std::filesystem::file_size(path, ignored) : 0;
  // One second and what honest unpacking of so many bytes takes (5 MB/s is ten times slower than measured).
  const ChildLimits childLimits{limits.bytes, 1 + std::min<std::size_t>(fileBytes, limits.bytes) / 5000000};
  return treeFromChild(path, childLimits, 2 * limits.bytes, limits.valuesUpTo != static_cast<std::size_t>(-1),
                       [&] { return hdf5::readTree(path, limits); });
}

}  // namespace squat::results
