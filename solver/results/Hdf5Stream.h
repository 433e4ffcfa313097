// solver/results/Hdf5Stream.h - columns of an HDF5 file that may be longer than the memory, in pieces and in order.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "results/ArrayTree.h"
#include "results/GuardedChild.h"

namespace squat::results {

// What a file holds: arrays with more than a few thousand values come without them (type, shape, attributes).
ArrayTree listHdf5(const std::string& path);

// A column of a dataset of numbers: samples along one axis, runs along the other.
struct Hdf5Column {
  std::string path;
  std::size_t run = 0, runs = 1;
  bool samplesFirst = true;
};

// The library works in a child process, as in readHdf5, and on a core of its own.
class Hdf5Stream {
 public:
  Hdf5Stream(std::string path, std::vector<Hdf5Column> columns, std::size_t samples);

  // The following samples of every column, behind those that are there; false: the end. Throws FileError.
  bool next(std::vector<std::vector<double>>& columns);

 private:
  std::string path_;
  std::vector<Hdf5Column> columns_;
  std::unique_ptr<GuardedChild> child_;
};

}  // namespace squat::results
