#include "results/Hdf5Reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include "results/Hdf5Fields.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Truncation.h"

namespace squat::results::hdf5 {

namespace {

constexpr int kDeepest = 8;
constexpr std::size_t kLongestFixedText = 4096;
constexpr std::size_t kMaximumTexts = 100000;
constexpr std::size_t kMaximumReferences = 10000;
constexpr std::size_t kMaximumPacked = 1100;  // deflate packs at most 1032 to one
constexpr const char* kHdf5Advice = "Use a file that this program has written";
constexpr const char* kForeignAdvice = "Export the signals alone, as plain numbers";

struct Names {
  std::vector<std::string> list;
  std::size_t maximum;
};

// For the library's walks over links and attributes; a negative value ends the walk with an error.
template <typename Info>
herr_t collectName(hid_t, const char* name, const Info*, void* names) {
  auto& found = *static_cast<Names*>(names);
  try {
    if (found.list.size() >= found.maximum) return -1;
    found.list.emplace_back(name);
    return 0;
  } catch (...) {
    return -1;
  }
}

bool isUnsigned(hid_t type) { return H5Tget_sign(type) == H5T_SGN_NONE; }

class Hdf5Walker {
 public:
  Hdf5Walker(const std::string& path, const Hdf5Limits& limits) : path_(path), limits_(limits) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (error) throw FileError(path_, "", "cannot be read: " + error.message(), "Check the path");
    if (!std::filesystem::is_regular_file(status)) throw FileError(path_, "", "is not a regular file", "Name a file");
    fileBytes_ = static_cast<std::size_t>(std::filesystem::file_size(path, error));
    if (error) throw FileError(path_, "", "cannot be read: " + error.message(), "Check the path");
  }

  ArrayTree walk() {
    const bool listed = limits_.valuesUpTo < limits_.bytes;
    const Handle file =
        listed ? openTruncated(path_) : Handle(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.valid()) refuse("", "is not an HDF5 file, or a damaged one (" + lastError() + ")");
    missing_ = missingBytes(file.get(), fileBytes_);
    ArrayTree tree;
    const Handle root(H5Gopen2(file.get(), "/", H5P_DEFAULT), H5Gclose);
    check(root.get(), path_, "/", "cannot be opened");
    tree.attributes = attributes(root.get(), "/");
    walkGroup(root.get(), "", tree, 0);
    nameReferences(tree);
    if (missing_ > 0)
      setAttribute(tree.attributes, truncationAttribute,
                   "its last " + std::to_string(missing_) + " bytes are missing" + lost_);
    return tree;
  }

 private:
  [[noreturn]] void refuse(const std::string& object, const std::string& what) const {
    throw FileError(path_, object, what, limits_.skipForeign ? kForeignAdvice : kHdf5Advice);
  }

  void walkGroup(hid_t group, const std::string& groupPath, ArrayTree& tree, int depth) {
    if (depth > kDeepest) refuse(groupPath, "groups are nested too deeply");
    for (const auto& name : linkNames(group, groupPath)) {
      const auto path = groupPath + "/" + name;
      if (std::find(limits_.without.begin(), limits_.without.end(), path) != limits_.without.end()) continue;
      if (++objects_ > limits_.objects) refuse(path, "too many objects");
      H5L_info_t link{};
      check(H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT), path_, path, "cannot be looked up");
      if (link.type == H5L_TYPE_SOFT && limits_.skipForeign) continue;
      if (link.type == H5L_TYPE_SOFT) refuse(path, "is a soft link, which is not followed");
      if (link.type == H5L_TYPE_EXTERNAL) refuse(path, "is a link into another file, which is not followed");
      if (link.type != H5L_TYPE_HARD) refuse(path, "is a link of unknown kind");
      addresses_.emplace(link.u.address, path);
      const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
      if (missing_ > 0 && !object.valid()) {
        noteLost(path);
        continue;
      }
      check(object.get(), path_, path, "cannot be opened");
      switch (H5Iget_type(object.get())) {
        case H5I_GROUP:
          addGroup(object.get(), path, tree, depth);
          break;
        case H5I_DATASET:
          if (isLost(object.get()))
            noteLost(path);
          else if (!limits_.skipForeign || isPlain(object.get()))
            tree.arrays.push_back(array(object.get(), path));
          else
            addForeign(object.get(), path, tree);
          break;
        default:
          if (!limits_.skipForeign) refuse(path, "is neither a group nor a dataset");
      }
    }
  }

  static bool isPlain(hid_t dataset) {
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const auto kind = H5Tget_class(type.get());
    return (kind == H5T_FLOAT || kind == H5T_INTEGER || kind == H5T_STRING) &&
           H5Tget_size(type.get()) <= kLongestFixedText;
  }

  // Records of named fields, each as an array of its own, and references to other objects, which nameReferences() turns
  // into their paths.
  void addForeign(hid_t dataset, const std::string& path, ArrayTree& tree) {
    const Handle type(H5Dget_type(dataset), H5Tclose);
    if (H5Tget_class(type.get()) == H5T_COMPOUND)
      addFields(dataset, type.get(), path, tree);
    else if (H5Tequal(type.get(), H5T_STD_REF_OBJ) > 0)
      addReferences(dataset, path, tree);
  }

  void addFields(hid_t dataset, hid_t type, const std::string& path, ArrayTree& tree) {
    checkLayout(dataset, path_, path, limits_);
    const Handle space(H5Dget_space(dataset), H5Sclose);
    std::vector<std::size_t> shape;
    const std::size_t count = readShape(space.get(), path, shape);
    if (count / kMaximumPacked > fileBytes_)
      refuse(path, "claims more values than the file can hold (" + std::to_string(count) + ")");
    for (const auto& field : numericFields(type)) {
      if (++objects_ > limits_.objects) refuse(path, "too many objects");
      Array array;
      array.path = path + "/" + field.name;
      array.shape = shape;
      if (field.perRow > 1) array.shape.push_back(field.perRow);
      const bool listed = count > limits_.valuesUpTo / field.perRow;
      array.values = numbers<double>(dataset, array.path, listed ? 0 : count * field.perRow, field.memory.get());
      array.attributes = attributes(dataset, path);
      tree.arrays.push_back(std::move(array));
    }
  }

  void addReferences(hid_t dataset, const std::string& path, ArrayTree& tree) {
    checkLayout(dataset, path_, path, limits_);
    Array array;
    array.path = path;
    const Handle space(H5Dget_space(dataset), H5Sclose);
    const std::size_t count = readShape(space.get(), path, array.shape);
    if (count > kMaximumReferences) return;
    references_.push_back({tree.arrays.size(), numbers<hobj_ref_t>(dataset, path, count, H5T_STD_REF_OBJ)});
    array.attributes = attributes(dataset, path);
    setAttribute(array.attributes, referencesAttribute, std::uint8_t{1});
    array.values = std::vector<std::string>(count);
    tree.arrays.push_back(std::move(array));
  }

  // A reference is the address of its object; objects that were not walked stay empty.
  void nameReferences(ArrayTree& tree) {
    for (const auto& [index, targets] : references_) {
      auto& paths = std::get<std::vector<std::string>>(tree.arrays[index].values);
      for (std::size_t i = 0; i < targets.size(); ++i)
        if (const auto found = addresses_.find(targets[i]); found != addresses_.end()) {
          account(found->second.size(), found->second);
          paths[i] = found->second;
        }
    }
  }

  // In a file that is cut off: what has no value left, and short arrays that are not whole.
  bool isLost(hid_t dataset) const {
    if (missing_ == 0) return false;
    const Handle space(H5Dget_space(dataset), H5Sclose);
    const auto count = H5Sget_simple_extent_npoints(space.get());
    std::array<hsize_t, H5S_MAX_RANK> extents{};
    const int rank = H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr);
    if (count <= 0 || rank <= 0) return false;
    const auto longest = std::max_element(extents.begin(), extents.begin() + rank);
    const auto present = presentAlong(dataset, static_cast<std::size_t>(longest - extents.begin()), fileBytes_);
    return present == 0 || (static_cast<std::size_t>(count) <= limits_.valuesUpTo && present < *longest);
  }

  void noteLost(const std::string& path) { lost_ += (lost_.empty() ? ", with all of " : ", ") + path; }

  void addGroup(hid_t group, const std::string& path, ArrayTree& tree, int depth) {
    Group entry{path, attributes(group, path)};
    if (!entry.attributes.empty()) tree.groups.push_back(std::move(entry));
    walkGroup(group, path, tree, depth + 1);
  }

  std::vector<std::string> linkNames(hid_t group, const std::string& path) const {
    const Handle creation(H5Gget_create_plist(group), H5Pclose);
    unsigned order = 0;
    if (creation.valid()) H5Pget_link_creation_order(creation.get(), &order);
    const auto index = (order & H5P_CRT_ORDER_TRACKED) ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
    Names names{{}, limits_.objects};
    check(H5Literate(group, index, H5_ITER_INC, nullptr, collectName<H5L_info_t>, &names), path_,
          path.empty() ? "/" : path, "its members cannot be listed");
    return names.list;
  }

  std::vector<Attribute> attributes(hid_t object, const std::string& path) {
    Names names{{}, 1000};
    check(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, collectName<H5A_info_t>, &names), path_, path,
          "its attributes cannot be listed");
    std::vector<Attribute> list;
    for (const auto& name : names.list)
      if (auto value = attributeValue(object, path + "@" + name, name)) list.push_back({name, std::move(*value)});
    return list;
  }

  // No value for kinds that this program does not write (arrays, references): other tools may add theirs.
  std::optional<AttributeValue> attributeValue(hid_t object, const std::string& where, const std::string& name) {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
    check(attribute.get(), path_, where, "cannot be opened");
    const Handle space(H5Aget_space(attribute.get()), H5Sclose);
    if (H5Sget_simple_extent_npoints(space.get()) != 1) return std::nullopt;
    const Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const auto size = H5Tget_size(type.get());
    switch (H5Tget_class(type.get())) {
      case H5T_FLOAT: {
        double value = 0;
        check(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), path_, where, "cannot be read");
        return value;
      }
      case H5T_INTEGER: {
        std::int64_t value = 0;
        check(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value), path_, where, "cannot be read");
        if (size == 1) return static_cast<std::uint8_t>(value);
        return value;
      }
      case H5T_STRING: {
        if (H5Tis_variable_str(type.get()) > 0) {
          char* text = nullptr;
          check(H5Aread(attribute.get(), type.get(), &text), path_, where, "cannot be read");
          return text ? ownedText(text) : std::string();
        }
        if (size > kLongestFixedText) refuse(where, "is too long");
        std::string text(size, '\0');
        check(H5Aread(attribute.get(), type.get(), text.data()), path_, where, "cannot be read");
        return text.substr(0, text.find('\0'));
      }
      default:
        return std::nullopt;
    }
  }

  std::string ownedText(char* text) {
    std::string copy(text);
    H5free_memory(text);
    account(copy.size(), "");
    return copy;
  }

  void account(std::size_t bytes, const std::string& path) {
    if (bytes > limits_.bytes - used_)
      refuse(path, "takes the file beyond " + std::to_string(limits_.bytes >> 20) + " MiB of values");
    used_ += bytes;
  }

  Array array(hid_t dataset, const std::string& path) {
    checkLayout(dataset, path_, path, limits_);
    Array array;
    array.path = path;
    const Handle space(H5Dget_space(dataset), H5Sclose);
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const std::size_t count = readShape(space.get(), path, array.shape);
    const auto typeSize = H5Tget_size(type.get());
    const bool listed = count > limits_.valuesUpTo;
    if (listed && count / kMaximumPacked > fileBytes_)
      refuse(path, "claims more values than the file can hold (" + std::to_string(count) + ")");
    const std::size_t read = listed ? 0 : count;
    switch (H5Tget_class(type.get())) {
      case H5T_FLOAT:
        if (typeSize > 8) refuse(path, "has a type that is not a number of 4 or 8 bytes");
        if (typeSize > 4)
          array.values = numbers<double>(dataset, path, read, H5T_NATIVE_DOUBLE);
        else
          array.values = numbers<float>(dataset, path, read, H5T_NATIVE_FLOAT);
        break;
      case H5T_INTEGER:
        if (typeSize > 8) refuse(path, "has whole numbers of more than 8 bytes");
        if (typeSize == 1 && isUnsigned(type.get()))
          array.values = numbers<std::uint8_t>(dataset, path, read, H5T_NATIVE_UINT8);
        else if (typeSize <= 2 || (typeSize <= 4 && !isUnsigned(type.get())))
          array.values = numbers<std::int32_t>(dataset, path, read, H5T_NATIVE_INT32);
        else
          array.values = numbers<std::int64_t>(dataset, path, read, H5T_NATIVE_INT64);
        break;
      case H5T_STRING:
        array.values = texts(dataset, path, read, type.get());
        break;
      default:
        refuse(path, "has a type that is neither a number nor text");
    }
    array.attributes = attributes(dataset, path);
    return array;
  }

  std::size_t readShape(hid_t space, const std::string& path, std::vector<std::size_t>& shape) const {
    const int rank = check(H5Sget_simple_extent_ndims(space), path_, path, "has no extents");
    if (static_cast<std::size_t>(rank) > limits_.rank) refuse(path, "has too many dimensions");
    std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
    if (rank > 0) check(H5Sget_simple_extent_dims(space, extents.data(), nullptr), path_, path, "has no extents");
    const std::size_t largest = limits_.valuesUpTo < limits_.bytes ? std::size_t{1} << 40 : limits_.bytes;
    std::size_t count = H5Sget_simple_extent_type(space) == H5S_NULL ? 0 : 1;
    for (const auto extent : extents) {
      if (extent != 0 && count > largest / extent)
        refuse(path, "has absurd extents (axis of " + std::to_string(extent) + " values)");
      count *= static_cast<std::size_t>(extent);
      shape.push_back(static_cast<std::size_t>(extent));
    }
    if (rank == 0 && count == 0) shape = {0};
    return count;
  }

  template <typename T>
  std::vector<T> numbers(hid_t dataset, const std::string& path, std::size_t count, hid_t type) {
    if (count * sizeof(T) / kMaximumPacked > fileBytes_)
      refuse(path, "claims more values than the file can hold (" + std::to_string(count) + ")");
    account(count * sizeof(T), path);
    std::vector<T> values(count);
    if (count > 0)
      check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path_, path, "cannot be read");
    return values;
  }

  std::vector<std::string> texts(hid_t dataset, const std::string& path, std::size_t count, hid_t type) {
    if (count > kMaximumTexts) refuse(path, "has too many texts");
    std::vector<std::string> list;
    if (count == 0) return list;
    if (H5Tis_variable_str(type) > 0) {
      std::vector<char*> pointers(count, nullptr);
      check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), path_, path, "cannot be read");
      for (char* pointer : pointers) list.push_back(pointer ? ownedText(pointer) : std::string());
      return list;
    }
    const auto size = H5Tget_size(type);
    if (size > kLongestFixedText) refuse(path, "has texts that are too long");
    account(count * size, path);
    std::string all(count * size, '\0');
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), path_, path, "cannot be read");
    for (std::size_t i = 0; i < count; ++i) list.emplace_back(std::string(all, i * size, size).c_str());
    return list;
  }

  std::string path_;
  Hdf5Limits limits_;
  std::size_t fileBytes_ = 0, objects_ = 0, used_ = 0;
  std::size_t missing_ = 0;  // [bytes] at the end of the file
  std::string lost_;         // arrays that are
  struct References {
    std::size_t array;  // in the tree
    std::vector<hobj_ref_t> targets;
  };
  std::vector<References> references_;
  std::map<haddr_t, std::string> addresses_;  // of the objects by hard links
};

}  // namespace

void checkLayout(hid_t dataset, const std::string& file, const std::string& path, const Hdf5Limits& limits) {
  const auto refuse = [&](const std::string& object, const std::string& what) {
    throw FileError(file, object, what, limits.skipForeign ? kForeignAdvice : kHdf5Advice);
  };
  const Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  check(creation.get(), file, path, "its layout cannot be read");
  if (H5Pget_external_count(creation.get()) != 0) refuse(path, "keeps its values in another file (external storage)");
  const auto layout = H5Pget_layout(creation.get());
  if (layout == H5D_VIRTUAL) refuse(path, "keeps its values in other files (virtual layout)");
  if (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) refuse(path, "has an unknown layout");
  const int filters = H5Pget_nfilters(creation.get());
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0, configuration = 0;
    std::size_t parameters = 0;
    const auto filter = H5Pget_filter2(creation.get(), static_cast<unsigned>(i), &flags, &parameters, nullptr, 0,
                                       nullptr, &configuration);
    if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32)
      refuse(path, "is packed with an unknown filter (" + std::to_string(filter) + ")");
  }
  if (layout == H5D_CHUNKED) {
    hsize_t extents[H5S_MAX_RANK] = {};
    const int rank = check(H5Pget_chunk(creation.get(), H5S_MAX_RANK, extents), file, path, "has no chunks");
    std::size_t size = 1;
    for (int axis = 0; axis < rank; ++axis) {
      if (extents[axis] == 0 || size > limits.chunkBytes / extents[axis]) refuse(path, "has absurd chunks");
      size *= extents[axis];
    }
  }
}

ArrayTree readTree(const std::string& path, const Hdf5Limits& limits) { return Hdf5Walker(path, limits).walk(); }

}  // namespace squat::results::hdf5
