#include "rcmdx/ExactColumns.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "results/ColumnPieces.h"
#include "results/Hdf5.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Reader.h"
#include "results/Hdf5Truncation.h"

namespace squat::rcmdx {
namespace {

using results::hdf5::check;
using results::hdf5::Handle;

constexpr double unknownValue = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t second = 1000000000;               // [ns]
constexpr std::int64_t latestTime = 9000000000 * second;  // in the year 2255
constexpr std::size_t longestWord = 64;

results::Hdf5Limits ofUntrustedFiles() {
  results::Hdf5Limits limits;
  limits.skipForeign = true;
  return limits;
}

double directionOf(std::string_view word) {
  for (const std::string_view one : {"FORWARD", "INCREASING", "ASCENDING"})
    if (word == one) return 1;
  for (const std::string_view one : {"BACKWARD", "DECREASING", "DESCENDING"})
    if (word == one) return -1;
  return 0;
}

// One dataset, read in hyperslabs.
class Line {
 public:
  // `bytes`: of the file, where it is cut off.
  Line(hid_t file, const std::string& path, const std::string& name, std::size_t samples,
       std::optional<std::size_t> bytes)
      : path_(path), name_(name) {
    const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    H5Pset_chunk_cache(access.get(), 1009, std::size_t{40} << 20, 1.0);  // a chunk is unpacked once
    dataset_ = Handle(H5Dopen2(file, name_.c_str(), access.get()), H5Dclose);
    check(dataset_.get(), path_, name_, "cannot be opened");
    results::hdf5::checkLayout(dataset_.get(), path_, name_, ofUntrustedFiles());
    type_ = Handle(H5Dget_type(dataset_.get()), H5Tclose);
    space_ = Handle(H5Dget_space(dataset_.get()), H5Sclose);
    const int rank = check(H5Sget_simple_extent_ndims(space_.get()), path_, name_, "has no extents");
    extents_.resize(static_cast<std::size_t>(rank));
    if (rank > 0)
      check(H5Sget_simple_extent_dims(space_.get(), extents_.data(), nullptr), path_, name_, "has no extents");
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < extents_.size(); ++axis) {
      count *= static_cast<std::size_t>(extents_[axis]);
      if (extents_[axis] == samples) axis_ = axis;
    }
    if (extents_.empty() || extents_[axis_] != samples || count != samples)
      throw FileError(path_, name_, "has changed while it was read");
    present_ = bytes ? results::hdf5::presentAlong(dataset_.get(), axis_, *bytes) : samples;
  }

  std::vector<double> read(Take take, std::size_t from, std::size_t count) {
    const std::size_t whole = present_ > from ? std::min(count, present_ - from) : 0;
    std::vector<double> values;
    if (whole > 0)
      values = take == Take::number      ? numbers<double>(H5T_NATIVE_DOUBLE, from, whole)
               : take == Take::direction ? directions(from, whole)
                                         : parts(take, from, whole);
    values.resize(count, unknownValue);
    return values;
  }

 private:
  // Selects the samples and returns the space of as many in memory.
  Handle select(std::size_t from, std::size_t count) {
    std::vector<hsize_t> start(extents_.size(), 0), size = extents_;
    start[axis_] = from;
    size[axis_] = count;
    check(H5Sselect_hyperslab(space_.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), path_, name_,
          "cannot be read in parts");
    const hsize_t all = count;
    return {H5Screate_simple(1, &all, nullptr), H5Sclose};
  }

  void readInto(void* values, hid_t type, std::size_t from, std::size_t count) {
    const auto memory = select(from, count);
    check(H5Dread(dataset_.get(), type, memory.get(), space_.get(), H5P_DEFAULT, values), path_, name_,
          ("cannot be read at sample " + std::to_string(from + 1)).c_str());
  }

  template <typename T>
  std::vector<T> numbers(hid_t type, std::size_t from, std::size_t count) {
    std::vector<T> values(count);
    readInto(values.data(), type, from, count);
    return values;
  }

  std::vector<double> parts(Take take, std::size_t from, std::size_t count) {
    auto times = numbers<std::int64_t>(H5T_NATIVE_INT64, from, count);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
      times[i] = std::clamp(times[i], std::int64_t{0}, latestTime);  // differences of damaged ones must not overflow
      const std::int64_t rest = times[i] % second;
      values[i] = static_cast<double>(take == Take::nanoseconds ? rest : (times[i] - rest) / second);
    }
    return values;
  }

  std::vector<double> directions(std::size_t from, std::size_t count) {
    std::vector<double> values(count, 0.0);
    if (H5Tget_class(type_.get()) != H5T_STRING) return values;
    if (H5Tis_variable_str(type_.get()) > 0) {
      std::vector<char*> words(count, nullptr);
      readInto(words.data(), type_.get(), from, count);
      for (std::size_t i = 0; i < count; ++i) {
        if (words[i]) values[i] = directionOf(words[i]);
        H5free_memory(words[i]);
      }
      return values;
    }
    const std::size_t size = H5Tget_size(type_.get());
    if (size > longestWord) return values;
    std::string all(count * size, '\0');
    readInto(all.data(), type_.get(), from, count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view word = std::string_view(all).substr(i * size, size);
      values[i] = directionOf(word.substr(0, word.find_first_of(std::string_view("\0 ", 2))));
    }
    return values;
  }

  std::string path_, name_;
  Handle dataset_, type_, space_;
  std::vector<hsize_t> extents_;
  std::size_t axis_ = 0, present_ = 0;
};

}  // namespace

void sendExactly(results::ReaderArguments& arguments, const results::ByteSink& send) {
  const auto path = arguments.text();
  const std::size_t samples = arguments.number();
  std::vector<ExactColumn> columns(arguments.number());
  for (auto& column : columns) {
    column.path = arguments.text();
    column.take = static_cast<Take>(arguments.number());
  }
  const Handle file = results::hdf5::openTruncated(path);
  check(file.get(), path, "", "is not an HDF5 file, or a damaged one");
  std::error_code ignored;
  std::optional<std::size_t> bytes = std::filesystem::file_size(path, ignored);
  if (results::hdf5::missingBytes(file.get(), *bytes) == 0) bytes.reset();
  std::map<std::string, Line> lines;
  for (const auto& column : columns) lines.try_emplace(column.path, file.get(), path, column.path, samples, bytes);
  std::vector<std::vector<double>> values(columns.size());
  for (std::size_t from = 0; from < samples; from += results::pieceSamples) {
    const std::size_t count = std::min(results::pieceSamples, samples - from);
    for (std::size_t c = 0; c < columns.size(); ++c)
      values[c] = lines.at(columns[c].path).read(columns[c].take, from, count);
    results::sendPiece(send, count, columns.size(), [&](std::size_t c) { return std::span<const double>(values[c]); });
  }
  results::sendEnd(send);
}

std::unique_ptr<results::ArrayStream> streamExactly(const std::string& path, const std::vector<ExactColumn>& columns,
                                                    std::size_t samples) {
  results::ChildLimits limits;
  limits.memory = std::size_t{128} << 20;
  limits.seconds = 10;
  for (const auto& column : columns) {  // cache and pieces; ten times as long as honest files take, words longer
    limits.memory += std::size_t{72} << 20;
    limits.seconds += samples / (column.take == Take::direction ? 200000 : 2000000);
  }
  results::ReaderCall call{"RCM-DX columns"};
  call.text(path).number(samples).number(columns.size());
  for (const auto& column : columns) call.text(column.path).number(static_cast<std::uint64_t>(column.take));
  return std::make_unique<results::ColumnPieces>(path, columns.size(), limits, call);
}

}  // namespace squat::rcmdx
