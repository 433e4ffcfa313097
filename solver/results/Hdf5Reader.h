// solver/results/Hdf5Reader.h - walking an HDF5 file in this process; only for the .cpp files of this folder and of
// rcmdx.
#pragma once

#include <hdf5.h>

#include <string>

#include "results/Hdf5.h"

namespace squat::results::hdf5 {

// The caller holds the lock of the library.
ArrayTree readTree(const std::string& path, const Hdf5Limits& limits);

// Throws FileError for layouts and filters that are not read, and for absurd chunks. `advice` ends the message.
void checkLayout(hid_t dataset, const std::string& path, const std::string& object, const Hdf5Limits& limits);

}  // namespace squat::results::hdf5
