// Reading with another program between the file and us: whatever the file does to the HDF5 library, it does there.
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "results/ColumnPieces.h"
#include "results/Hdf5.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Reader.h"

namespace squat::results {

namespace {

ReaderCall& putLimits(ReaderCall& call, const Hdf5Limits& limits) {
  call.number(limits.bytes).number(limits.objects).number(limits.rank).number(limits.chunkBytes);
  call.number(limits.skipForeign ? 1 : 0).number(limits.valuesUpTo).number(limits.without.size());
  for (const auto& group : limits.without) call.text(group);
  return call;
}

Hdf5Limits takeLimits(ReaderArguments& arguments) {
  Hdf5Limits limits;
  for (auto* value : {&limits.bytes, &limits.objects, &limits.rank, &limits.chunkBytes}) *value = arguments.number();
  limits.skipForeign = arguments.number() != 0;
  limits.valuesUpTo = arguments.number();
  limits.without.resize(arguments.number());
  for (auto& group : limits.without) group = arguments.text();
  return limits;
}

}  // namespace

ArrayTree readOwnHdf5(const std::string& path, const Hdf5Limits& limits) {
  const auto lock = hdf5::lockLibrary();
  return hdf5::readTree(path, limits);
}

void sendHdf5Tree(ReaderArguments& arguments, const ByteSink& send) {
  const auto path = arguments.text();
  sendTree(hdf5::readTree(path, takeLimits(arguments)), send);
}

ArrayTree readHdf5(const std::string& path, const Hdf5Limits& limits) {
  std::error_code ignored;
  const auto fileBytes =
      std::filesystem::is_regular_file(path, ignored) ? std::filesystem::file_size(path, ignored) : 0;
  // One second and what honest unpacking of so many bytes takes (5 MB/s is ten times slower than measured).
  const ChildLimits childLimits{limits.bytes, 1 + std::min<std::size_t>(fileBytes, limits.bytes) / 5000000};
  return treeFromChild(path, childLimits, 2 * limits.bytes, limits.valuesUpTo != static_cast<std::size_t>(-1),
                       putLimits(ReaderCall{"HDF5 tree"}.text(path), limits));
}

}  // namespace squat::results
