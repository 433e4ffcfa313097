#include "results/ColumnPieces.h"

#include <cstdint>

namespace squat::results {
namespace {

constexpr char kPiece = 'P', kEndOfPieces = 'Z', kTree = 'T';

void sendKind(const ByteSink& send, char kind) { send(std::as_bytes(std::span(&kind, 1))); }

}  // namespace

void sendTree(const ArrayTree& tree, const ByteSink& send) {
  sendKind(send, kTree);
  encodeTree(tree, send);
}

void sendPiece(const ByteSink& send, std::size_t count, std::size_t columns, const ColumnValues& values) {
  const std::uint64_t samples = count;
  sendKind(send, kPiece);
  send(std::as_bytes(std::span(&samples, 1)));
  for (std::size_t c = 0; c < columns; ++c) send(std::as_bytes(values(c)));
}

void sendEnd(const ByteSink& send) { sendKind(send, kEndOfPieces); }

bool ColumnPieces::next(std::vector<std::vector<double>>& columns) {
  if (!child_) return false;
  const char kind = child_->receiveKind();
  if (kind == kEndOfPieces) {
    child_.reset();
    return false;
  }
  std::uint64_t count = 0;
  const auto fill = [&](std::span<std::byte> bytes) {
    if (child_->receive(bytes) != bytes.size()) child_->died();
  };
  if (kind != kPiece) child_->died();
  fill(std::as_writable_bytes(std::span(&count, 1)));
  if (count > pieceSamples) child_->died();
  columns.resize(columns_);
  for (auto& column : columns) {
    const std::size_t before = column.size();
    column.resize(before + static_cast<std::size_t>(count));
    fill(std::as_writable_bytes(std::span(column).subspan(before)));
  }
  return true;
}

ArrayTree treeFromChild(const std::string& path, const ChildLimits& limits, std::size_t largestBytes, bool listed,
                        const ReaderCall& call) {
  GuardedChild child(path, limits, call);
  child.receiveKind();
  try {
    auto tree =
        decodeTree([&](std::span<std::byte> wanted) { return child.receive(wanted); }, path, largestBytes, listed);
    child.wait();
    return tree;
  } catch (const FileError&) {
    child.died();
  }
}

}  // namespace squat::results
