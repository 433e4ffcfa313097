#include "results/MatlabFile.h"

#include <matio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "core/CheckedCounts.h"
#include "core/Errors.h"
#include "results/ColumnPieces.h"
#include "text/Utf8Text.h"

namespace squat::results {
namespace {

constexpr std::size_t kListed = 4096;                    // values that come with a listed array
constexpr std::size_t kLargest = std::size_t{4} << 30;   // [bytes] of values in the reading program
constexpr std::size_t kWhole = std::size_t{384} << 20;   // [bytes] of a file that is read whole
constexpr std::size_t kLibrary = std::size_t{64} << 20;  // [bytes] that the library itself needs
constexpr std::size_t kObjects = 20000, kDepth = 8, kRank = 4;
constexpr std::size_t kLongestText = 4096;
constexpr const char* kMatlabAdvice = "Save it again, with the option -v7.3 if it is large";

using Handler = std::function<void(const std::string& path, mat_t* file, matvar_t* array)>;

// The library prints; what goes wrong becomes a FileError. Newer ones hand a text over that cannot be changed.
template <typename Character>
void ignoreMessage(int, Character*) {}

bool isNumeric(const matvar_t& array) {
  return array.class_type >= MAT_C_DOUBLE && array.class_type <= MAT_C_UINT64 && !array.isComplex && array.rank > 0 &&
         static_cast<std::size_t>(array.rank) <= kRank;
}

bool isText(const matvar_t& array) { return array.class_type == MAT_C_CHAR && array.rank == 2; }

std::size_t countOf(const matvar_t& array) {
  std::optional<std::size_t> count = 1;
  for (int axis = 0; count && axis < array.rank; ++axis) count = checkedProduct(*count, array.dims[axis]);
  return count.value_or(static_cast<std::size_t>(-1));
}

// The elements of the file, each behind its type and size, must lie within it: the library takes what is cut off for
// empty.
void requireWhole(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(path, ignored);
  std::array<unsigned char, 8> tag{};
  in.seekg(126);
  const bool littleEndian = in.get() == 'I';
  for (std::uintmax_t at = 128; at < bytes;) {
    in.seekg(static_cast<std::streamoff>(at));
    in.read(reinterpret_cast<char*>(tag.data()), tag.size());
    std::uintmax_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8 | tag[littleEndian ? 7 - i : 4 + i];
    if (in.gcount() < static_cast<std::streamsize>(tag.size()) || size > bytes - at - tag.size())
      throw FileError(path, "byte " + std::to_string(at), "the file is cut off here",
                      "Copy it again from where it was recorded");
    at += tag.size() + size;
  }
}

// "run" of a single structure, "run(2)" of an array of them.
std::string elementName(const std::string& name, std::size_t index, std::size_t count) {
  return count == 1 ? name : name + "(" + std::to_string(index + 1) + ")";
}

// Calls `handle` for every array of numbers and every text in the file.
class MatlabWalker {
 public:
  MatlabWalker(const std::string& path, const Handler& handle) : path_(path), handle_(handle) {
    requireWhole(path);
    Mat_LogInitFunc("squat", ignoreMessage);
    file_.reset(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
    if (!file_) throw FileError(path, "", "is not a MATLAB file, or a damaged one", kMatlabAdvice);
  }
  void walk() {
    while (const Variable variable{Mat_VarReadNextInfo(file_.get())})
      visit(std::string("/").append(variable->name ? variable->name : ""), variable.get(), 0);
  }

 private:
  struct Close {
    void operator()(mat_t* file) const { Mat_Close(file); }
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
  };
  using Variable = std::unique_ptr<matvar_t, Close>;

  void visit(const std::string& name, matvar_t* variable, std::size_t depth) {
    if (++objects_ > kObjects || depth > kDepth)
      throw FileError(path_, name, "is one of too many objects", kMatlabAdvice);
    if (isNumeric(*variable) || isText(*variable)) return handle_(name, file_.get(), variable);
    const std::size_t count = countOf(*variable);
    if (count > kObjects) return;
    if (variable->class_type == MAT_C_CELL)
      for (std::size_t i = 0; i < count; ++i)
        if (auto* cell = Mat_VarGetCell(variable, static_cast<int>(i)))
          visit(name + "{" + std::to_string(i + 1) + "}", cell, depth + 1);
    if (variable->class_type != MAT_C_STRUCT) return;
    const unsigned fields = Mat_VarGetNumberOfFields(variable);
    char* const* const names = Mat_VarGetStructFieldnames(variable);
    for (std::size_t element = 0; element < count; ++element)
      for (unsigned i = 0; names && i < fields; ++i)
        if (auto* field = Mat_VarGetStructFieldByIndex(variable, i, element); field && names[i])
          visit(elementName(name, element, count) + "/" + names[i], field, depth + 1);
  }

  const std::string& path_;
  const Handler& handle_;
  std::unique_ptr<mat_t, Close> file_;
  std::size_t objects_ = 0;
};

template <typename T>
void append(std::vector<double>& to, const matvar_t& array, std::size_t count) {
  const auto* values = static_cast<const T*>(array.data);
  to.assign(values, values + count);
}

// The values of an array, first index fastest.
std::vector<double> valuesOf(const std::string& path, const std::string& name, mat_t* file, matvar_t* array) {
  const std::size_t count = countOf(*array);
  if (count > kLargest / sizeof(double)) throw FileError(path, name, "is larger than 4 GB", kMatlabAdvice);
  if (count == 0) return {};
  if (Mat_VarReadDataAll(file, array) != 0 || !array->data)
    throw FileError(path, name, "cannot be read: the file is damaged or cut off", kMatlabAdvice);
  std::vector<double> values;
  const auto take = [&]<typename T>(T) {
    if (array->nbytes < count * sizeof(T)) throw FileError(path, name, "is damaged", kMatlabAdvice);
    append<T>(values, *array, count);
  };
  switch (array->class_type) {
    case MAT_C_DOUBLE:
      take(double{});
      break;
    case MAT_C_SINGLE:
      take(float{});
      break;
    case MAT_C_INT8:
      take(std::int8_t{});
      break;
    case MAT_C_UINT8:
      take(std::uint8_t{});
      break;
    case MAT_C_INT16:
      take(std::int16_t{});
      break;
    case MAT_C_UINT16:
      take(std::uint16_t{});
      break;
    case MAT_C_INT32:
      take(std::int32_t{});
      break;
    case MAT_C_UINT32:
      take(std::uint32_t{});
      break;
    case MAT_C_INT64:
      take(std::int64_t{});
      break;
    case MAT_C_UINT64:
      take(std::uint64_t{});
      break;
    default:
      throw FileError(path, name, "is no array of numbers", kMatlabAdvice);
  }
  return values;
}

// A line of text; empty for longer ones and for several lines.
std::string textOf(const std::string& path, const std::string& name, mat_t* file, matvar_t* array) {
  const std::size_t count = countOf(*array);
  if (count == 0 || count > kLongestText || array->dims[0] != 1) return {};
  if (Mat_VarReadDataAll(file, array) != 0 || !array->data)
    throw FileError(path, name, "cannot be read: the file is damaged or cut off", kMatlabAdvice);
  if (array->data_type == MAT_T_UTF8) return std::string(static_cast<const char*>(array->data), array->nbytes);
  std::vector<std::uint16_t> characters(count);
  const std::size_t size = array->data_type == MAT_T_UINT16 || array->data_type == MAT_T_UTF16 ? 2 : 1;
  if (array->nbytes < count * size) throw FileError(path, name, "is damaged", kMatlabAdvice);
  for (std::size_t i = 0; i < count; ++i)
    characters[i] = size == 2 ? static_cast<const std::uint16_t*>(array->data)[i]
                              : static_cast<const std::uint8_t*>(array->data)[i];
  return text::utf8FromUtf16(characters);
}

// In the reading program.
ArrayTree treeOf(const std::string& path, std::size_t valuesUpTo) {
  ArrayTree tree;
  std::size_t bytes = 0;
  const Handler handle = [&](const std::string& name, mat_t* file, matvar_t* array) {
    Array found;
    found.path = name;
    if (isText(*array)) {
      found.shape = {1};
      found.values = std::vector<std::string>{textOf(path, name, file, array)};
      tree.arrays.push_back(std::move(found));
      return;
    }
    found.shape.assign(array->dims, array->dims + array->rank);
    std::reverse(found.shape.begin(), found.shape.end());
    const std::size_t count = countOf(*array);
    if (count <= valuesUpTo) {
      bytes += std::min(count, kLargest) * sizeof(double);
      if (bytes > kWhole) throw FileError(path, name, "holds more than 384 MB", "Give a shorter record");
      found.values = valuesOf(path, name, file, array);
    } else {
      found.values = std::vector<double>();
    }
    tree.arrays.push_back(std::move(found));
  };
  MatlabWalker(path, handle).walk();
  return tree;
}

ArrayTree guardedTree(const std::string& path, std::size_t valuesUpTo) {
  std::error_code ignored;
  const std::size_t fileBytes = std::filesystem::file_size(path, ignored);
  // What honest unpacking takes, as of HDF5 files.
  const ChildLimits limits{2 * kWhole + kLibrary, 2 + std::min(fileBytes, 4 * kWhole) / 5000000};
  return treeFromChild(path, limits, 2 * kWhole, valuesUpTo != static_cast<std::size_t>(-1),
                       ReaderCall{"MATLAB tree"}.text(path).number(valuesUpTo));
}

}  // namespace

void sendMatlabTree(ReaderArguments& arguments, const ByteSink& send) {
  const auto path = arguments.text();
  sendTree(treeOf(path, arguments.number()), send);
}

void sendMatlabColumns(ReaderArguments& arguments, const ByteSink& send) {
  const auto path = arguments.text();
  const std::size_t samples = arguments.number();
  const auto columns = takeColumns(arguments);
  std::map<std::string, std::vector<double>> arrays;
  for (const auto& column : columns) arrays[column.path];
  const Handler handle = [&](const std::string& name, mat_t* file, matvar_t* array) {
    if (const auto wanted = arrays.find(name); wanted != arrays.end())
      wanted->second = valuesOf(path, name, file, array);
  };
  MatlabWalker(path, handle).walk();
  std::vector<std::vector<double>> pieces(columns.size());
  for (std::size_t from = 0; from < samples; from += pieceSamples) {
    const std::size_t count = std::min(pieceSamples, samples - from);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto& column = columns[c];
      const auto& values = arrays[column.path];
      if (values.size() != samples * column.runs) throw FileError(path, column.path, "has changed while it was read");
      pieces[c].resize(count);
      for (std::size_t i = 0; i < count; ++i)
        pieces[c][i] =
            values[column.samplesFirst ? (from + i) * column.runs + column.run : column.run * samples + from + i];
    }
    sendPiece(send, count, columns.size(), [&](std::size_t c) { return std::span<const double>(pieces[c]); });
  }
  sendEnd(send);
}

ArrayTree readMatlabFile(const std::string& path) { return guardedTree(path, static_cast<std::size_t>(-1)); }
ArrayTree listMatlabFile(const std::string& path) { return guardedTree(path, kListed); }

std::unique_ptr<ArrayStream> streamMatlabFile(const std::string& path, const std::vector<ArrayColumn>& columns,
                                              std::size_t samples) {
  std::map<std::string, std::size_t> runs;
  for (const auto& column : columns) runs[column.path] = column.runs;
  ChildLimits limits{2 * kLibrary, 10};
  for (const auto& [name, count] : runs) {  // as stored and as double; ten times as long as honest files take
    const std::size_t bytes = std::min(kLargest, samples * count * sizeof(double));
    limits.memory += 2 * bytes;
    limits.seconds += bytes / 16000000;
  }
  ReaderCall call{"MATLAB columns"};
  putColumns(call.text(path).number(samples), columns);
  return std::make_unique<ColumnPieces>(path, columns.size(), limits, call);
}

}  // namespace squat::results
