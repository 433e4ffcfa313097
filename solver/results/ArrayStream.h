// solver/results/ArrayStream.h - columns of the arrays of a file that may be longer than the memory, in pieces.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace squat::results {

// A column of an array of numbers: samples along one axis, runs along the other.
struct ArrayColumn {
  std::string path;
  std::size_t run = 0, runs = 1;
  bool samplesFirst = true;
};

class ArrayStream {
 public:
  virtual ~ArrayStream() = default;
  // The following samples of every column, behind those that are there; false: the end. Throws FileError.
  virtual bool next(std::vector<std::vector<double>>& columns) = 0;
};

}  // namespace squat::results
