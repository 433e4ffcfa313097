// solver/results/ColumnPieces.h - columns of numbers on their way from the child process that reads a file.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/ArrayStream.h"
#include "results/GuardedChild.h"
#include "results/TreeStream.h"

namespace squat::results {

inline constexpr std::size_t pieceSamples = std::size_t{1} << 16;  // of a column, at most

// In the child: `count` samples of each column, then the next ones; at last the end.
using ColumnValues = std::function<std::span<const double>(std::size_t column)>;
void sendPiece(const ByteSink& send, std::size_t count, std::size_t columns, const ColumnValues& values);
void sendEnd(const ByteSink& send);

// In the parent: what comes, as an array stream.
class ColumnPieces : public ArrayStream {
 public:
  ColumnPieces(const std::string& path, std::size_t columns, const ChildLimits& limits, GuardedChild::Work work)
      : columns_(columns), child_(std::make_unique<GuardedChild>(path, limits, std::move(work))) {}
  bool next(std::vector<std::vector<double>>& columns) override;

 private:
  std::size_t columns_;
  std::unique_ptr<GuardedChild> child_;
};

// A tree that `read` makes in a child process. `listed`: arrays may come without their values.
ArrayTree treeFromChild(const std::string& path, const ChildLimits& limits, std::size_t largestBytes, bool listed,
                        const std::function<ArrayTree()>& read);

}  // namespace squat::results
