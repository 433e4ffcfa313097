// Reading with a child process between the file and us: whatever the file does to the HDF5 library, it does there.
#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>

#include "results/GuardedChild.h"
#include "results/Hdf5.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Reader.h"
#include "results/TreeStream.h"

namespace squat::results {
namespace {

constexpr char kTree = 'T';

}  // namespace

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
  GuardedChild child(path, childLimits, [&](const ByteSink& send) {
    const auto tree = hdf5::readTree(path, limits);
    const char kind = kTree;
    send(std::as_bytes(std::span(&kind, 1)));
    encodeTree(tree, send);
  });
  child.receiveKind();
  try {
    auto tree = decodeTree([&](std::span<std::byte> wanted) { return child.receive(wanted); }, path, 2 * limits.bytes,
                           limits.valuesUpTo != static_cast<std::size_t>(-1));
    child.wait();
    return tree;
  } catch (const FileError&) {
    child.died();
  }
}

}  // namespace squat::results
