// solver/readers/ArraySignals.h - signals from HDF5 and MATLAB files; see SignalFile.h for what is understood.
#pragma once

#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "results/ArrayStream.h"
#include "results/ArrayTree.h"
#include "text/DelimitedTable.h"

namespace squat::readers {

std::vector<signals::Record> readArraySignals(const std::string& path, const SignalFileOptions& options);

// The columns of the dataset or group that is read, and the options with what the file adds: rate, speed, the dataset.
// A tree without values (listArrays) gives columns without values.
struct ArrayColumns {
  text::DelimitedTable table;
  std::vector<results::ArrayColumn> places;  // of each column
  std::size_t samples = 0;
  SignalFileOptions options;
};
ArrayColumns columnsOf(const std::string& path, const results::ArrayTree& tree, const SignalFileOptions& options);

// All runs of a table: the part that text and HDF5 have in common.
std::vector<signals::Record> signalsOf(const text::DelimitedTable& table, const SignalFileOptions& options);

}  // namespace squat::readers
