// solver/rcmdx/TypedFile.h - an HDF5 file in memory whose types are those that a specification asks for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "results/Hdf5Handle.h"

namespace squat::rcmdx {

// Whole numbers and floats are little-endian of their own width; texts are UTF-8 of variable length.
using Cells = std::variant<std::vector<std::string>, std::vector<std::int8_t>, std::vector<std::int16_t>,
                           std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<std::uint64_t>,
                           std::vector<float>, std::vector<double>>;
using Cell = std::variant<std::string, std::int8_t, std::int16_t, std::int32_t, std::int64_t, std::uint64_t, float>;

// Paths are absolute; the groups above an object are made with it. No time stamps: equal content gives equal bytes.
// Throws FileError where the library refuses. Holds the library's lock as long as it lives.
class TypedFile {
 public:
  explicit TypedFile(const std::string& path);

  void group(const std::string& group);
  void attribute(const std::string& object, const std::string& name, const Cell& value);
  void dataset(const std::string& dataset, const Cells& values);
  void link(const std::string& object, const std::string& name);  // another name for an object that is there
  std::vector<std::byte> bytes();                                 // nothing can be added behind it

 private:
  std::string path_;
  std::unique_lock<std::mutex> lock_;
  results::hdf5::Handle file_, withParents_;
};

}  // namespace squat::rcmdx
