#include "rcmdx/TypedFile.h"

#include <type_traits>

#include "core/Errors.h"

namespace squat::rcmdx {
namespace {

using results::hdf5::check;
using results::hdf5::Handle;

Handle variableText() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

// In the file and in memory alike: this program runs on little-endian machines.
template <typename T>
Handle typeOf() {
  if constexpr (std::is_same_v<T, std::string>) {
    return variableText();
  } else {
    const hid_t type = std::is_same_v<T, std::int8_t>     ? H5T_STD_I8LE
                       : std::is_same_v<T, std::int16_t>  ? H5T_STD_I16LE
                       : std::is_same_v<T, std::int32_t>  ? H5T_STD_I32LE
                       : std::is_same_v<T, std::int64_t>  ? H5T_STD_I64LE
                       : std::is_same_v<T, std::uint64_t> ? H5T_STD_U64LE
                       : std::is_same_v<T, float>         ? H5T_IEEE_F32LE
                                                          : H5T_IEEE_F64LE;
    return {H5Tcopy(type), H5Tclose};
  }
}

}  // namespace

TypedFile::TypedFile(const std::string& path) : path_(path), lock_(results::hdf5::lockLibrary()) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(H5Pset_fapl_core(access.get(), std::size_t{1} << 20, false), path_, "/", "cannot be prepared");
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  file_ = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
  check(file_.get(), path_, "/", "cannot be created");
  withParents_ = Handle(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(withParents_.get(), 1);
}

void TypedFile::group(const std::string& group) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  const Handle made(H5Gcreate2(file_.get(), group.c_str(), withParents_.get(), creation.get(), H5P_DEFAULT), H5Gclose);
  check(made.get(), path_, group, "the group cannot be made");
}

void TypedFile::attribute(const std::string& object, const std::string& name, const Cell& value) {
  const auto where = object + "@" + name;
  const Handle owner(H5Oopen(file_.get(), object.c_str(), H5P_DEFAULT), H5Oclose);
  check(owner.get(), path_, object, "cannot be opened");
  std::visit(
      [&](const auto& one) {
        using T = std::decay_t<decltype(one)>;
        const auto type = typeOf<T>();
        const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
        const Handle made(H5Acreate2(owner.get(), name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose);
        check(made.get(), path_, where, "the attribute cannot be made");
        if constexpr (std::is_same_v<T, std::string>) {
          const char* text = one.c_str();
          check(H5Awrite(made.get(), type.get(), &text), path_, where, "cannot be written");
        } else {
          check(H5Awrite(made.get(), type.get(), &one), path_, where, "cannot be written");
        }
      },
      value);
}

void TypedFile::dataset(const std::string& dataset, const Cells& values) {
  std::visit(
      [&](const auto& list) {
        using T = typename std::decay_t<decltype(list)>::value_type;
        const auto type = typeOf<T>();
        const hsize_t count = list.size();
        const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_obj_track_times(creation.get(), false);
        const Handle made(H5Dcreate2(file_.get(), dataset.c_str(), type.get(), space.get(), withParents_.get(),
                                     creation.get(), H5P_DEFAULT),
                          H5Dclose);
        check(made.get(), path_, dataset, "the dataset cannot be made");
        if (list.empty()) return;
        if constexpr (std::is_same_v<T, std::string>) {
          std::vector<const char*> texts;
          for (const auto& text : list) texts.push_back(text.c_str());
          check(H5Dwrite(made.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()), path_, dataset,
                "cannot be written");
        } else {
          check(H5Dwrite(made.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, list.data()), path_, dataset,
                "cannot be written");
        }
      },
      values);
}

void TypedFile::link(const std::string& object, const std::string& name) {
  check(H5Lcreate_hard(file_.get(), object.c_str(), file_.get(), name.c_str(), withParents_.get(), H5P_DEFAULT), path_,
        name, "the link cannot be made");
}

std::vector<std::byte> TypedFile::bytes() {
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), path_, "/", "cannot be flushed");
  const auto size = check(H5Fget_file_image(file_.get(), nullptr, 0), path_, "/", "has no image");
  std::vector<std::byte> image(static_cast<std::size_t>(size));
  check(H5Fget_file_image(file_.get(), image.data(), image.size()), path_, "/", "has no image");
  if (!file_.reset()) throw FileError(path_, "/", "cannot be closed");
  return image;
}

}  // namespace squat::rcmdx
