// solver/results/TreeStream.h - an ArrayTree as a stream of bytes: exact, quick, every section with its checksum.
// Used by checkpoints and between the programs of a guarded reader. Little-endian, this program's own:
//   "SQTREE01", then sections of [kind u8][length u64][payload][CRC-32 of the payload u32];
//   kind 1 root attributes, 2 group, 3 array, 0 end (its payload is the number of sections before it).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "results/ArrayTree.h"

namespace squat::results {

// Takes all bytes or throws.
using ByteSink = std::function<void(std::span<const std::byte>)>;
// Fills the span from its beginning and returns how many bytes came; fewer than asked only at the end of the stream.
using ByteSource = std::function<std::size_t(std::span<std::byte>)>;

// CRC-32 (IEEE 802.3, reflected polynomial 0xEDB88320), continued from `previous`.
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t previous = 0);

void encodeTree(const ArrayTree& tree, const ByteSink& sink);
std::vector<std::byte> encodeTree(const ArrayTree& tree);

// Refuses damage, truncation and trailing bytes with FileError(path, section, ...). Takes no more memory than the bytes
// that really come, and at most about twice `largestBytes`. `listed`: arrays may come without their values.
ArrayTree decodeTree(const ByteSource& source, const std::string& path, std::size_t largestBytes, bool listed = false);

// A source over bytes in memory; `bytes` must outlive it.
ByteSource sourceOf(std::span<const std::byte> bytes);

}  // namespace squat::results
