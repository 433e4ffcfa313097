// solver/readers/Hdf5Signals.h - signals from HDF5 files; see SignalFile.h for what is understood.
#pragma once

#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "text/DelimitedTable.h"

namespace squat::readers {

std::vector<signals::Record> readHdf5Signals(const std::string& path, const SignalFileOptions& options);

// All runs of a table: the part that text and HDF5 have in common.
std::vector<signals::Record> signalsOf(const text::DelimitedTable& table, const SignalFileOptions& options);

}  // namespace squat::readers
