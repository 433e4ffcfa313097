// solver/results/MatlabFile.h - MATLAB files of the versions 5 to 7.2, which MATLAB, Octave and SciPy write unless
// asked for 7.3 (7.3 is HDF5).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "results/ArrayStream.h"
#include "results/ArrayTree.h"

namespace squat::results {

bool isMatlabFile(const std::string& path);

// Real arrays of numbers and lines of text, those of structures as "/structure/field", of arrays of structures as
// "/structure(2)/field", of cells as "/cell{2}"; the extents as HDF5 has them in a file of version 7.3, the last one
// first. Everything else (objects, complex numbers, sparse matrices) is passed over. The library works in a
// program of its own, as in readHdf5. Throws FileError.
ArrayTree readMatlabFile(const std::string& path);
// The same, but arrays with more than a few thousand values come without them.
ArrayTree listMatlabFile(const std::string& path);

// The columns in pieces. That program holds the arrays that they come from whole: in these versions an array has 2 GB
// at most.
std::unique_ptr<ArrayStream> streamMatlabFile(const std::string& path, const std::vector<ArrayColumn>& columns,
                                              std::size_t samples);

}  // namespace squat::results
