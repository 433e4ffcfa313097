// solver/readers/Hdf5Signals.h - signals from HDF5 files; see SignalFile.h for what is understood.
#pragma once

#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "results/Hdf5Stream.h"
#include "text/DelimitedTable.h"

namespace squat::readers {

std::vector<signals::Record> readHdf5Signals(const std::string& path, const SignalFileOptions& options);

// The columns of the dataset or group that is read, and the options with what the file adds: rate, speed, the dataset.
// A tree without values (results::listHdf5) gives columns without values.
struct Hdf5Columns {
  text::DelimitedTable table;
  std::vector<results::Hdf5Column> places;  // of each column
  std::size_t samples = 0;
  SignalFileOptions options;
};
Hdf5Columns columnsOf(const std::string& path, const results::ArrayTree& tree, const SignalFileOptions& options);

// All runs of a table: the part that text and HDF5 have in common.
std::vector<signals::Record> signalsOf(const text::DelimitedTable& table, const SignalFileOptions& options);

}  // namespace squat::readers
