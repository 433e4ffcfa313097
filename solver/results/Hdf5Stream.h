// solver/results/Hdf5Stream.h - columns of an HDF5 file that may be longer than the memory, in pieces and in order.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "results/ArrayStream.h"
#include "results/ArrayTree.h"

namespace squat::results {

// What a file holds: arrays with more than a few thousand values come without them (type, shape, attributes).
ArrayTree listHdf5(const std::string& path);

// The columns in pieces. The library works in a program of its own, as in readHdf5, and on a core of its own.
std::unique_ptr<ArrayStream> streamHdf5(const std::string& path, const std::vector<ArrayColumn>& columns,
                                        std::size_t samples);

}  // namespace squat::results
