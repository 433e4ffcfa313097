// solver/results/Hdf5Truncation.h - files that end before their last value; only for the .cpp files of this folder and
// of rcmdx.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>

#include "results/Hdf5Handle.h"

namespace squat::results::hdf5 {

// Opens a file for reading, also where it ends before what it says it holds; the library alone refuses such a file. An
// invalid handle where it is no HDF5 file.
Handle openTruncated(const std::string& path);

// [bytes] that the file ends too early; 0 where it is whole. `bytes`: its size.
std::size_t missingBytes(hid_t file, std::size_t bytes);

// How many values along an axis, from the first on, lie wholly within the first `bytes` of the file, whatever the other
// indices. What lies beyond cannot be read, or reads as zero.
std::size_t presentAlong(hid_t dataset, std::size_t axis, std::size_t bytes);

}  // namespace squat::results::hdf5
