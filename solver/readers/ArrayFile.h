// solver/readers/ArrayFile.h - files of named arrays, whichever format they have: HDF5 (MATLAB 7.3 included) or MATLAB
// 5 to 7.2.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "results/ArrayStream.h"
#include "results/ArrayTree.h"

namespace squat::readers {

// By its signature, not by its name; HDF5 may stand behind a user block.
bool isArrayFile(const std::string& path);

// All of them throw FileError.
results::ArrayTree readArrays(const std::string& path);  // limits: see SignalFile.h
results::ArrayTree listArrays(const std::string& path);  // long arrays without their values
std::unique_ptr<results::ArrayStream> streamArrays(const std::string& path,
                                                   const std::vector<results::ArrayColumn>& columns,
                                                   std::size_t samples);

}  // namespace squat::readers
