// Writing: tree -> image of an HDF5 file in memory.
#include <algorithm>
#include <set>
#include <type_traits>

#include "results/Hdf5.h"
#include "results/Hdf5Handle.h"

namespace squat::results {

namespace {

using hdf5::check;
using hdf5::Handle;

constexpr std::size_t kWorthPacking = 1024;  // [bytes]
constexpr hsize_t kChunkValues = 65536;

template <typename T>
hid_t memoryType() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

Handle textType() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), H5T_VARIABLE);  // held outside the header: a long case fits, and h5py reads it as str
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

class Image {
 public:
  explicit Image(const std::string& path) : path_(path) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    check(H5Pset_fapl_core(access.get(), std::size_t{4} << 20, false), path_, "/", "cannot be prepared");
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    check(H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), path_, "/",
          "cannot be prepared");
    H5Pset_obj_track_times(creation.get(), false);
    file_ = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
    check(file_.get(), path_, "/", "cannot be created");
  }

  void attributes(const std::string& object, const std::vector<Attribute>& list) {
    const Handle owner(H5Oopen(file_.get(), object.c_str(), H5P_DEFAULT), H5Oclose);
    check(owner.get(), path_, object, "cannot be opened");
    for (const auto& attribute : list)
      std::visit([&](const auto& value) { writeAttribute(owner, object, attribute.name, value); }, attribute.value);
  }

  // Makes the group and those above it, in the order of asking.
  void group(const std::string& path) {
    if (path.empty() || path == "/" || !made_.insert(path).second) return;
    group(path.substr(0, path.rfind('/')));
    const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    H5Pset_obj_track_times(creation.get(), false);
    const Handle made(H5Gcreate2(file_.get(), path.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose);
    check(made.get(), path_, path, "the group cannot be made");
  }

  void array(const Array& array) {
    group(array.path.substr(0, array.path.rfind('/')));
    std::visit([&](const auto& values) { writeArray(array, values); }, array.values);
    attributes(array.path, array.attributes);
  }

  std::vector<std::byte> bytes() {
    check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), path_, "/", "cannot be flushed");
    const auto size = check(H5Fget_file_image(file_.get(), nullptr, 0), path_, "/", "has no image");
    std::vector<std::byte> image(static_cast<std::size_t>(size));
    check(H5Fget_file_image(file_.get(), image.data(), image.size()), path_, "/", "has no image");
    if (!file_.reset()) throw FileError(path_, "/", "cannot be closed");
    return image;
  }

 private:
  template <typename T>
  void writeAttribute(const Handle& owner, const std::string& object, const std::string& name, const T& value) {
    constexpr bool isText = std::is_same_v<T, std::string>;
    Handle text;
    hid_t type = H5I_INVALID_HID;
    if constexpr (isText) {
      text = textType();
      type = text.get();
    } else {
      type = memoryType<T>();
    }
    const auto where = object + "@" + name;
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle made(H5Acreate2(owner.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(made.get(), path_, where, "the attribute cannot be made");
    if constexpr (isText) {
      const char* data = value.c_str();
      check(H5Awrite(made.get(), type, &data), path_, where, "cannot be written");
    } else {
      check(H5Awrite(made.get(), type, &value), path_, where, "cannot be written");
    }
  }

  template <typename T>
  void writeArray(const Array& array, const std::vector<T>& values) {
    constexpr bool isText = std::is_same_v<T, std::string>;
    Handle text;
    hid_t type = H5I_INVALID_HID;
    if constexpr (isText) {
      text = textType();
      type = text.get();
    } else {
      type = memoryType<T>();
    }
    const std::vector<hsize_t> extents(array.shape.begin(), array.shape.end());
    const Handle space(extents.empty() ? H5Screate(H5S_SCALAR)
                                       : H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
                       H5Sclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.get(), false);
    if (!isText && !extents.empty() && values.size() * sizeof(T) >= kWorthPacking) {
      check(H5Pset_chunk(creation.get(), static_cast<int>(extents.size()), chunk(extents).data()), path_, array.path,
            "its chunks cannot be set");
      H5Pset_shuffle(creation.get());
      H5Pset_deflate(creation.get(), 2);
    }
    const Handle made(
        H5Dcreate2(file_.get(), array.path.c_str(), type, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
        H5Dclose);
    check(made.get(), path_, array.path, "the dataset cannot be made");
    if (values.empty()) return;
    if constexpr (isText) {
      std::vector<const char*> pointers;
      for (const auto& value : values) pointers.push_back(value.c_str());
      check(H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), path_, array.path,
            "cannot be written");
    } else {
      check(H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path_, array.path,
            "cannot be written");
    }
  }

  // Whole rows of the last axes, about kChunkValues together.
  static std::vector<hsize_t> chunk(const std::vector<hsize_t>& extents) {
    std::vector<hsize_t> size = extents;
    hsize_t row = 1;
    for (std::size_t axis = extents.size(); axis-- > 0;) {
      size[axis] = std::clamp<hsize_t>(kChunkValues / row, 1, extents[axis]);
      row *= size[axis];
    }
    return size;
  }

  std::string path_;
  Handle file_;
  std::set<std::string> made_;
};

}  // namespace

std::vector<std::byte> encodeHdf5(const ArrayTree& tree, const std::string& path) {
  const auto lock = hdf5::lockLibrary();
  Image image(path);
  image.attributes("/", tree.attributes);
  for (const auto& array : tree.arrays) image.array(array);
  for (const auto& group : tree.groups) {
    image.group(group.path);
    image.attributes(group.path, group.attributes);
  }
  return image.bytes();
}

}  // namespace squat::results
