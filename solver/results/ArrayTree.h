// solver/results/ArrayTree.h - named arrays with attributes: the plain value that stands between the program's own
// types and any file. Result files (HDF5) and checkpoints (own binary format) hold one tree each. Paths look like
// "/signals/aba": absolute, parts separated by single slashes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/Errors.h"

namespace squat::results {

using Values = std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>,
                            std::vector<std::int32_t>, std::vector<std::uint8_t>, std::vector<std::string>>;
using AttributeValue = std::variant<std::string, double, std::int64_t, std::uint8_t>;

struct Attribute {
  std::string name;
  AttributeValue value;
  bool operator==(const Attribute&) const = default;
};

struct Array {
  std::string path;
  Values values;
  std::vector<std::size_t> shape;  // empty: a single number; the product is the number of values
  std::vector<Attribute> attributes;
  bool operator==(const Array&) const = default;
};

struct Group {
  std::string path;
  std::vector<Attribute> attributes;
  bool operator==(const Group&) const = default;
};

struct ArrayTree {
  std::vector<Attribute> attributes;  // of the root
  std::vector<Group> groups;          // only those with attributes, or empty ones
  std::vector<Array> arrays;          // in the order of writing

  // Both return the new member for further filling. `shape` empty: a line of values.
  Array& add(std::string path, Values values, std::string unit, std::vector<std::size_t> shape = {});
  Array& addScalar(std::string path, double value, std::string unit);
  Group& addGroup(std::string path);

  const Array* find(std::string_view path) const;  // null where there is none
  const Group* findGroup(std::string_view path) const;
  Array* find(std::string_view path);
};

void setAttribute(std::vector<Attribute>& attributes, std::string name, AttributeValue value);
// Text or number of an attribute; the fallback where it is missing or of another kind.
std::string textAttribute(const std::vector<Attribute>& attributes, std::string_view name,
                          const std::string& fallback = {});
double numberAttribute(const std::vector<Attribute>& attributes, std::string_view name, double fallback = 0);

// The values of an array. Throws FileError(file, path) where it is missing or holds another type.
template <typename T>
const std::vector<T>& valuesOf(const ArrayTree& tree, std::string_view path, const std::string& file) {
  const auto* array = tree.find(path);
  if (!array) throw FileError(file, std::string(path), "is missing");
  const auto* values = std::get_if<std::vector<T>>(&array->values);
  if (!values) throw FileError(file, std::string(path), "has a wrong type");
  return *values;
}

std::size_t valueCount(const Values& values);
std::size_t byteCount(const Values& values);  // memory of the values, strings included
std::size_t byteCount(const ArrayTree& tree);

// Path of the first array or group that one of the two lacks or that differs in the last bit of a value, in type, shape
// or attributes (a not-a-number equals itself, zero differs from minus zero); "/" for attributes of the root; empty
// where the trees are the same. The order of arrays and attributes does not count.
std::string firstDifference(const ArrayTree& left, const ArrayTree& right);

// Path of the first array that holds a not-a-number or an infinity; empty where all are finite.
std::string firstNotFinite(const ArrayTree& tree);

}  // namespace squat::results
