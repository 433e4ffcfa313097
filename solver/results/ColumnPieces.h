// solver/results/ColumnPieces.h - columns of numbers on their way from the program that reads a file.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "results/ArrayStream.h"
#include "results/GuardedChild.h"
#include "results/TreeStream.h"

namespace squat::results {

inline constexpr std::size_t pieceSamples = std::size_t{1} << 16;  // of a column, at most

// In the reading program: a tree, whole; `count` samples of each column, then the next ones; at last the end.
using ColumnValues = std::function<std::span<const double>(std::size_t column)>;
void sendTree(const ArrayTree& tree, const ByteSink& send);
void sendPiece(const ByteSink& send, std::size_t count, std::size_t columns, const ColumnValues& values);
void sendEnd(const ByteSink& send);

// In the program that asked: what comes, as an array stream.
class ColumnPieces : public ArrayStream {
 public:
  ColumnPieces(const std::string& path, std::size_t columns, const ChildLimits& limits, const ReaderCall& call)
      : columns_(columns), child_(std::make_unique<GuardedChild>(path, limits, call)) {}
  bool next(std::vector<std::vector<double>>& columns) override;

 private:
  std::size_t columns_;
  std::unique_ptr<GuardedChild> child_;
};

// A tree that `call` has read. `listed`: arrays may come without their values.
ArrayTree treeFromChild(const std::string& path, const ChildLimits& limits, std::size_t largestBytes, bool listed,
                        const ReaderCall& call);

}  // namespace squat::results
