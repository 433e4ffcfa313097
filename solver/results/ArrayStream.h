// solver/results/ArrayStream.h - columns of the arrays of a file that may be longer than the memory, in pieces.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace squat::results {

// How numbers are packed into those that are stored (attributes scale_factor, add_offset and _FillValue of the CF
// conventions): number = factor * stored + offset, and none where `missing` is stored.
struct Packing {
  double factor = 1, offset = 0;
  double missing = std::numeric_limits<double>::quiet_NaN();
  bool isNone() const { return factor == 1 && offset == 0 && std::isnan(missing); }
};
inline double unpacked(double stored, const Packing& packing) {
  return stored == packing.missing ? std::numeric_limits<double>::quiet_NaN()
                                   : packing.factor * stored + packing.offset;
}

// A column of an array of numbers: samples along one axis, runs along the other.
struct ArrayColumn {
  std::string path;
  std::size_t run = 0, runs = 1;
  bool samplesFirst = true;
  Packing packing = {};
};

class ArrayStream {
 public:
  virtual ~ArrayStream() = default;
  // The following samples of every column, behind those that are there; false: the end. Throws FileError.
  virtual bool next(std::vector<std::vector<double>>& columns) = 0;
};

}  // namespace squat::results
