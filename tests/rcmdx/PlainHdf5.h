// Small HDF5 files by the library's C interface alone, and what stands in a file: for tests of the RCM-DX format, which
// must not be checked with the code that they test.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdint>
#include <string>
#include <vector>

namespace squat::tests {

class PlainHdf5 {
 public:
  enum class Open { made, read };
  PlainHdf5(const std::string& path, Open how)
      : file_(how == Open::made ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                                : H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    EXPECT_GE(file_, 0) << path;
  }
  ~PlainHdf5() { H5Fclose(file_); }
  PlainHdf5(const PlainHdf5&) = delete;
  PlainHdf5& operator=(const PlainHdf5&) = delete;

  void group(const std::string& path) {
    const hid_t group = H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(group, 0) << path;
    H5Gclose(group);
  }
  // `inMemory` and `inFile`: types of the value.
  void attribute(const std::string& object, const char* name, hid_t inMemory, hid_t inFile, const void* value) {
    const hid_t owner = H5Oopen(file_, object.c_str(), H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t made = H5Acreate2(owner, name, inFile, space, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(made, inMemory, value), 0) << object << '@' << name;
    H5Aclose(made), H5Sclose(space), H5Oclose(owner);
  }
  void text(const std::string& object, const char* name, const std::string& value) {
    const hid_t type = textType();
    const char* pointer = value.c_str();
    attribute(object, name, type, type, &pointer);
    H5Tclose(type);
  }
  void element(const std::string& path, const char* element) {
    group(path);
    text(path, "Element", element);
  }
  template <typename T>
  void dataset(const std::string& path, const std::vector<T>& values, hid_t inMemory, hid_t inFile) {
    const hsize_t count = values.size(), chunk = 10000;
    const hid_t space = H5Screate_simple(1, &count, nullptr), creation = H5Pcreate(H5P_DATASET_CREATE);
    if (count > chunk) H5Pset_chunk(creation, 1, &chunk), H5Pset_deflate(creation, 1);
    const hid_t made = H5Dcreate2(file_, path.c_str(), inFile, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    EXPECT_GE(H5Dwrite(made, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
    H5Dclose(made), H5Pclose(creation), H5Sclose(space);
  }
  void texts(const std::string& path, const std::vector<std::string>& values) {
    std::vector<const char*> pointers;
    for (const auto& value : values) pointers.push_back(value.c_str());
    const hid_t type = textType();
    dataset(path, pointers, type, type);
    H5Tclose(type);
  }
  void remove(const std::string& path) { EXPECT_GE(H5Ldelete(file_, path.c_str(), H5P_DEFAULT), 0) << path; }

  // What stands there: "group", "string", "int16", "uint64", "float32", ..., with "[3]" behind a dataset of three
  // values; "nothing".
  std::string kindOf(const std::string& path) {
    if (!exists(path)) return "nothing";
    const hid_t object = H5Oopen(file_, path.c_str(), H5P_DEFAULT);
    if (H5Iget_type(object) == H5I_GROUP) return H5Oclose(object), "group";
    const hid_t type = H5Dget_type(object), space = H5Dget_space(object);
    const auto kind = nameOf(type) + "[" + std::to_string(H5Sget_simple_extent_npoints(space)) + "]";
    H5Sclose(space), H5Tclose(type), H5Oclose(object);
    return kind;
  }
  std::string kindOfAttribute(const std::string& object, const std::string& name) {
    if (!exists(object) || H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) <= 0) return "nothing";
    const hid_t found = H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(found);
    const auto kind = nameOf(type);
    H5Tclose(type), H5Aclose(found);
    return kind;
  }
  std::string textOf(const std::string& object, const std::string& name) {
    const hid_t found = H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = textType();
    char* text = nullptr;
    EXPECT_GE(H5Aread(found, type, &text), 0) << object << '@' << name;
    std::string copy = text ? text : "";
    H5free_memory(text), H5Tclose(type), H5Aclose(found);
    return copy;
  }
  template <typename T>
  T numberOf(const std::string& object, const std::string& name, hid_t type) {
    const hid_t found = H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    T value{};
    EXPECT_GE(H5Aread(found, type, &value), 0) << object << '@' << name;
    H5Aclose(found);
    return value;
  }
  template <typename T>
  std::vector<T> valuesOf(const std::string& path, hid_t type) {
    const hid_t found = H5Dopen2(file_, path.c_str(), H5P_DEFAULT), space = H5Dget_space(found);
    std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(found, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
    H5Sclose(space), H5Dclose(found);
    return values;
  }
  std::vector<std::string> textsOf(const std::string& path) {
    const hid_t type = textType();
    std::vector<std::string> copies;
    for (char* text : valuesOf<char*>(path, type)) copies.emplace_back(text ? text : ""), H5free_memory(text);
    H5Tclose(type);
    return copies;
  }

 private:
  static hid_t textType() {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE), H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
  }
  static std::string nameOf(hid_t type) {
    const auto bits = std::to_string(8 * H5Tget_size(type));
    if (H5Tget_class(type) == H5T_STRING) return H5Tis_variable_str(type) > 0 ? "string" : "fixed string";
    if (H5Tget_class(type) == H5T_FLOAT) return "float" + bits;
    if (H5Tget_class(type) == H5T_INTEGER) return (H5Tget_sign(type) == H5T_SGN_NONE ? "uint" : "int") + bits;
    return "another type";
  }
  // Every group on the way must be there before the library may be asked for the last.
  bool exists(const std::string& path) {
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
      if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == std::string::npos) return true;
    }
  }

  hid_t file_;
};

}  // namespace squat::tests
