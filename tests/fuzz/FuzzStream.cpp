// Checkpoints and what the guarded reader sends: any bytes give a tree or a FileError; any tree gives a result whose
// lengths fit, or a FileError. Checksums would stop the search at the door: where they are wrong they are mended first.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/Errors.h"
#include "results/ResultTree.h"
#include "results/TreeStream.h"

namespace {

std::vector<std::byte> withRightChecksums(std::vector<std::byte> bytes) {
  std::size_t at = 8;
  while (bytes.size() >= 13 && at <= bytes.size() - 13) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data() + at + 1, sizeof length);
    if (length > bytes.size() - at - 13) break;
    const auto payload = std::span(bytes).subspan(at + 9, static_cast<std::size_t>(length));
    const auto sum = squat::results::crc32(payload);
    std::memcpy(bytes.data() + at + 9 + length, &sum, sizeof sum);
    at += 13 + static_cast<std::size_t>(length);
  }
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const auto bytes = withRightChecksums({first, first + size});
  try {
    const auto tree = results::decodeTree(results::sourceOf(bytes), "fuzz", std::size_t{64} << 20);
    if (!results::firstDifference(tree, tree).empty()) std::abort();
    const auto again = results::encodeTree(tree);
    const auto result = results::fromTree(tree, "fuzz");
    for (const auto& channel : result.signals)
      if (channel.values.size() != result.time.size()) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
