// python/Records.h - measured signals as Python hands them over: files, or arrays in memory.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "records/RecordStream.h"

namespace squat::python {

// A column that is read where it stands; whoever made it keeps the array alive.
struct ArrayColumn {
  std::string heading;  // name and unit, "aba [m/s2]"
  const char* data = nullptr;
  pybind11::ssize_t stride = 0;  // [bytes]
  std::size_t size = 0;
  bool isSingle = false;  // float, else double

  double at(std::size_t index) const;
};

// A record of arrays, all of one length.
struct ArrayRecord {
  std::string name;  // for messages and lists
  std::vector<ArrayColumn> columns;
  std::vector<pybind11::array> owners;
};

// `arrays`: dict of heading and array (n), or one array (n), which is "aba [m/s2]". Arrays of float64 and float32 are
// read in place; others are converted. Throws CaseError where they have other than one dimension or different lengths.
ArrayRecord arrayRecord(const std::string& name, const pybind11::object& arrays);
// Whether arrayRecord() is for such an object.
bool isArrays(const pybind11::object& object);

// The record as the readers of files give one, with the same checks. The columns must outlive it. Throws as
// records::openRecord().
std::unique_ptr<records::RecordStream> openArrays(const ArrayRecord& record, const records::RecordOptions& options);

// The record as the text of a CSV file, every digit kept.
std::string csvOf(const ArrayRecord& record);

// A file's path; of "example-record" the shipped one.
std::string recordFile(const std::string& nameOrPath);

// Arguments by the names of the command line's options: column, time_column, position_column, speed_column, run_column,
// object, rate, speed, unit, time_unit, delimiter, decimal_comma, head_line. Throws TypeError of Python for another
// name, CaseError for a wrong value.
readers::SignalFileOptions readingFrom(const pybind11::kwargs& arguments);

}  // namespace squat::python
