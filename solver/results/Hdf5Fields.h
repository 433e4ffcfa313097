// solver/results/Hdf5Fields.h - datasets of records, whose fields are arrays of their own: "/dataset/field"; only for
// the .cpp files of this folder.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <vector>

#include "results/Hdf5Handle.h"

namespace squat::results::hdf5 {

struct NumericField {
  std::string name;        // with slashInName for a slash
  std::size_t perRow = 1;  // values: more than one where the field is a short array
  Handle memory;           // type that reads this field alone, as double
};

// The fields of a compound type that are numbers, or lines of at most 1024 of them.
std::vector<NumericField> numericFields(hid_t compound);

// A dataset of numbers, or one field of a dataset of records. `dataset` is not valid where there is neither.
struct NumberSource {
  Handle dataset, memory;
  std::size_t perRow = 1;
};
NumberSource openNumbers(hid_t file, const std::string& path, hid_t access);

}  // namespace squat::results::hdf5
