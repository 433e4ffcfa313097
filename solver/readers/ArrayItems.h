// solver/readers/ArrayItems.h - the arrays of a file under the names that their user knows, whichever program wrote it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/ArrayStream.h"
#include "results/ArrayTree.h"

namespace squat::readers {

struct ArrayItem {
  const results::Array* array = nullptr;  // where it is stored
  std::string path;                       // as its user knows it: "/simout/signals(2)/values"
  std::string group, name, unit;          // what stands together, and under which name; unit empty: not stated
  results::Packing packing;
};

enum class Channels {
  joined,  // channels of a group of their own, each with values beside its name and unit, stand in the group above
  asTheyStand
};

// What holds numbers. Understood are
//   attributes unit, units, Unit, Units, unit_string; those of CF (netCDF): "seconds since ...", scale_factor,
//     add_offset, _FillValue
//   cells and arrays of structures of MATLAB: "/data{2}", "/run(2)/aba", in version 7.3 too, where they are references
//   channels that are groups or structures: values or data, beside them texts called unit and name or label
//     ("structure with time" of Simulink; time stands in the group above)
// Left out: text, dimensions of netCDF without values.
std::vector<ArrayItem> itemsOf(const results::ArrayTree& tree, Channels channels = Channels::joined);

// Samples along the longest axis; 1: a single number.
std::size_t lengthOf(const results::Array& array);
// More than two axes are longer than 1.
bool isNested(const results::Array& array);

// "/run" of "/run/aba", empty of "/aba"; and the rest.
std::string parentOf(const std::string& path);
std::string nameOf(const std::string& path);

}  // namespace squat::readers
