#include "results/ResultFile.h"

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Hdf5.h"
#include "results/ResultTree.h"

namespace squat::results {

namespace {

// Leaves out every second snapshot but the first and the last until the rest fits.
RunResult thinned(RunResult result, std::size_t maximum) {
  const auto count = result.snapshots.size();
  while (result.snapshots.size() > 2 && byteCount(toTree(result)) > maximum) {
    std::vector<SurfaceSnapshot> kept;
    for (std::size_t i = 0; i < result.snapshots.size(); ++i)
      if (i % 2 == 0 || i + 1 == result.snapshots.size()) kept.push_back(std::move(result.snapshots[i]));
    if (kept.size() == result.snapshots.size()) kept.erase(kept.begin() + 1);
    result.snapshots = std::move(kept);
  }
  result.warnings.push_back("the file keeps " + std::to_string(result.snapshots.size()) + " of " +
                            std::to_string(count) + " field snapshots: all would make it too large to read");
  return result;
}

}  // namespace

void writeResult(const std::string& path, const RunResult& result) {
  const Hdf5Limits limits;
  const std::size_t maximum = limits.bytes / 10 * 9;
  auto tree = toTree(result);
  if (byteCount(tree) > maximum) tree = toTree(thinned(result, maximum));
  const auto image = encodeHdf5(tree, path);
  writeDurably(path, image, [&](const std::string& part) {
    const auto object = firstDifference(tree, readOwnHdf5(part, limits));
    if (!object.empty()) throw FileError(path, object, "did not read back as it was written", "Check the disk");
  });
}

RunResult readResult(const std::string& path, ResultContent content) {
  Hdf5Limits limits;
  if (content == ResultContent::withoutFields) limits.without = {"/mesh/surface", "/fields", "/patch"};
  return fromTree(readHdf5(path, limits), path);
}

bool isCompleteResult(const std::string& path) noexcept {
  try {
    return readResult(path).complete;
  } catch (...) {
    return false;
  }
}

}  // namespace squat::results
