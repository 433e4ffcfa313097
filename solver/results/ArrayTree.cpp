#include "results/ArrayTree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace squat::results {

namespace {

template <typename Members>
auto* findByPath(Members& members, std::string_view path) {
  const auto found = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.path == path; });
  return found == members.end() ? nullptr : &*found;
}

const Attribute* findAttribute(const std::vector<Attribute>& attributes, std::string_view name) {
  for (const auto& attribute : attributes)
    if (attribute.name == name) return &attribute;
  return nullptr;
}

template <typename T>
bool sameBits(const std::vector<T>& left, const std::vector<T>& right) {
  if constexpr (std::is_same_v<T, std::string>)
    return left == right;
  else
    return left.size() == right.size() &&
           (left.empty() || std::memcmp(left.data(), right.data(), left.size() * sizeof(T)) == 0);
}

bool sameBits(const AttributeValue& left, const AttributeValue& right) {
  if (left.index() != right.index()) return false;
  if (const double* number = std::get_if<double>(&left))
    return std::bit_cast<std::uint64_t>(*number) == std::bit_cast<std::uint64_t>(std::get<double>(right));
  return left == right;
}

bool sameBits(const std::vector<Attribute>& left, const std::vector<Attribute>& right) {
  return left.size() == right.size() && std::all_of(left.begin(), left.end(), [&](const Attribute& attribute) {
           const auto* other = findAttribute(right, attribute.name);
           return other && sameBits(attribute.value, other->value);
         });
}

bool sameBits(const Array& left, const Array& right) {
  return left.path == right.path && left.shape == right.shape && left.values.index() == right.values.index() &&
         sameBits(left.attributes, right.attributes) &&
         std::visit(
             [&](const auto& values) {
               return sameBits(values, std::get<std::decay_t<decltype(values)>>(right.values));
             },
             left.values);
}

}  // namespace

Array& ArrayTree::add(std::string path, Values values, std::string unit, std::vector<std::size_t> shape) {
  if (shape.empty()) shape = {valueCount(values)};
  arrays.push_back({std::move(path), std::move(values), std::move(shape), {}});
  setAttribute(arrays.back().attributes, "unit", std::move(unit));
  return arrays.back();
}

Array& ArrayTree::addScalar(std::string path, double value, std::string unit) {
  arrays.push_back({std::move(path), std::vector<double>{value}, {}, {}});
  setAttribute(arrays.back().attributes, "unit", std::move(unit));
  return arrays.back();
}

Group& ArrayTree::addGroup(std::string path) {
  groups.push_back({std::move(path), {}});
  return groups.back();
}

const Array* ArrayTree::find(std::string_view path) const { return findByPath(arrays, path); }
Array* ArrayTree::find(std::string_view path) { return findByPath(arrays, path); }
const Group* ArrayTree::findGroup(std::string_view path) const { return findByPath(groups, path); }

void setAttribute(std::vector<Attribute>& attributes, std::string name, AttributeValue value) {
  for (auto& attribute : attributes)
    if (attribute.name == name) {
      attribute.value = std::move(value);
      return;
    }
  attributes.push_back({std::move(name), std::move(value)});
}

std::string textAttribute(const std::vector<Attribute>& attributes, std::string_view name,
                          const std::string& fallback) {
  const auto* attribute = findAttribute(attributes, name);
  const auto* text = attribute ? std::get_if<std::string>(&attribute->value) : nullptr;
  return text ? *text : fallback;
}

double numberAttribute(const std::vector<Attribute>& attributes, std::string_view name, double fallback) {
  const auto* attribute = findAttribute(attributes, name);
  if (!attribute) return fallback;
  if (const auto* number = std::get_if<double>(&attribute->value)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&attribute->value)) return static_cast<double>(*whole);
  if (const auto* flag = std::get_if<std::uint8_t>(&attribute->value)) return *flag;
  return fallback;
}

std::size_t valueCount(const Values& values) {
  return std::visit([](const auto& v) { return v.size(); }, values);
}

std::size_t byteCount(const Values& values) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&values)) {
    std::size_t bytes = texts->size() * sizeof(std::string);
    for (const auto& text : *texts) bytes += text.size();
    return bytes;
  }
  return std::visit([](const auto& v) { return v.size() * sizeof(v[0]); }, values);
}

std::size_t byteCount(const ArrayTree& tree) {
  std::size_t bytes = 0;
  for (const auto& array : tree.arrays) bytes += byteCount(array.values);
  return bytes;
}

std::string firstDifference(const ArrayTree& left, const ArrayTree& right) {
  if (!sameBits(left.attributes, right.attributes)) return "/";
  for (const auto& array : left.arrays) {
    const auto* other = right.find(array.path);
    if (!other || !sameBits(array, *other)) return array.path;
  }
  for (const auto& group : left.groups) {
    const auto* other = right.findGroup(group.path);
    if (!other || !sameBits(group.attributes, other->attributes)) return group.path;
  }
  for (const auto& array : right.arrays)
    if (!left.find(array.path)) return array.path;
  for (const auto& group : right.groups)
    if (!left.findGroup(group.path)) return group.path;
  return {};
}

std::string firstNotFinite(const ArrayTree& tree) {
  for (const auto& array : tree.arrays) {
    const bool finite = std::visit(
        [](const auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_floating_point_v<T>)
            return std::all_of(values.begin(), values.end(), [](T v) { return std::isfinite(v); });
          else
            return true;
        },
        array.values);
    if (!finite) return array.path;
  }
  return {};
}

}  // namespace squat::results
