#include "results/Hdf5Fields.h"

#include <algorithm>
#include <array>

#include "results/Hdf5.h"

namespace squat::results::hdf5 {
namespace {

constexpr std::size_t mostPerRow = 1024;
constexpr int mostFields = 1000;

std::string fieldName(hid_t compound, unsigned index) {
  char* text = H5Tget_member_name(compound, index);
  if (!text) return {};
  std::string name;
  for (const char* c = text; *c; ++c) *c == '/' ? name += slashInName : name += *c;
  H5free_memory(text);
  return name;
}

bool isNumber(hid_t type) {
  const auto kind = H5Tget_class(type);
  return (kind == H5T_FLOAT || kind == H5T_INTEGER) && H5Tget_size(type) <= sizeof(double);
}

// Values in a row of the field: 1 for a number, the extent of a line of numbers, 0 for anything else.
std::size_t valuesPerRow(hid_t type) {
  if (H5Tget_class(type) != H5T_ARRAY) return isNumber(type) ? 1 : 0;
  const Handle element(H5Tget_super(type), H5Tclose);
  std::array<hsize_t, H5S_MAX_RANK> extents{};
  if (!isNumber(element.get()) || H5Tget_array_ndims(type) != 1 || H5Tget_array_dims2(type, extents.data()) != 1)
    return 0;
  return extents[0] <= mostPerRow ? static_cast<std::size_t>(extents[0]) : 0;
}

Handle memoryOf(hid_t compound, unsigned index, std::size_t perRow) {
  const hsize_t extent = perRow;
  const Handle line(H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &extent), H5Tclose);
  const Handle member(H5Tget_member_type(compound, index), H5Tclose);
  const bool isLine = H5Tget_class(member.get()) == H5T_ARRAY;
  Handle memory(H5Tcreate(H5T_COMPOUND, perRow * sizeof(double)), H5Tclose);
  char* name = H5Tget_member_name(compound, index);
  if (!name || H5Tinsert(memory.get(), name, 0, isLine ? line.get() : H5T_NATIVE_DOUBLE) < 0) memory.reset();
  H5free_memory(name);
  return memory;
}

}  // namespace

std::vector<NumericField> numericFields(hid_t compound) {
  std::vector<NumericField> fields;
  const int count = std::min(H5Tget_nmembers(compound), mostFields);
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<unsigned>(i);
    const Handle type(H5Tget_member_type(compound, index), H5Tclose);
    const std::size_t perRow = valuesPerRow(type.get());
    if (perRow == 0) continue;
    NumericField field{fieldName(compound, index), perRow, memoryOf(compound, index, perRow)};
    if (!field.name.empty() && field.memory.valid()) fields.push_back(std::move(field));
  }
  return fields;
}

NumberSource openNumbers(hid_t file, const std::string& path, hid_t access) {
  NumberSource source;
  source.dataset = Handle(H5Dopen2(file, path.c_str(), access), H5Dclose);
  if (source.dataset.valid()) {
    source.memory = Handle(H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose);
    return source;
  }
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos || slash == 0) return source;
  Handle records(H5Dopen2(file, path.substr(0, slash).c_str(), access), H5Dclose);
  const Handle type(H5Dget_type(records.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_COMPOUND) return source;
  for (auto& field : numericFields(type.get()))
    if (field.name == path.substr(slash + 1)) return {std::move(records), std::move(field.memory), field.perRow};
  return source;
}

}  // namespace squat::results::hdf5
