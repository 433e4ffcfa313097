#include "results/Hdf5Stream.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "results/ColumnPieces.h"
#include "results/Hdf5.h"
#include "results/Hdf5Fields.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Reader.h"
#include "results/Hdf5Truncation.h"

namespace squat::results {
namespace {

using hdf5::check;
using hdf5::Handle;

constexpr std::size_t pieceValues = std::size_t{1} << 23;  // of one dataset, all runs

Hdf5Limits foreign() {
  Hdf5Limits limits;
  limits.skipForeign = true;
  limits.valuesUpTo = 4096;
  limits.objects = 200000;  // recordings of RCM-DX hold a group for each picture
  return limits;
}

// One dataset, read in hyperslabs over all of its runs.
class Dataset {
 public:
  // `bytes`: of the file, where it is cut off.
  Dataset(hid_t file, const std::string& path, const ArrayColumn& column, std::size_t samples,
          std::optional<std::size_t> bytes)
      : path_(path), name_(column.path), runs_(column.runs), samplesFirst_(column.samplesFirst) {
    const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    // A chunk is unpacked once, whatever its size: the largest that is read is 32 MB.
    H5Pset_chunk_cache(access.get(), 1009, std::size_t{40} << 20, 1.0);
    numbers_ = hdf5::openNumbers(file, name_, access.get());
    check(numbers_.dataset.get(), path_, name_, "cannot be opened");
    hdf5::checkLayout(numbers_.dataset.get(), path_, name_, foreign());
    space_ = Handle(H5Dget_space(numbers_.dataset.get()), H5Sclose);
    const int rank = check(H5Sget_simple_extent_ndims(space_.get()), path_, name_, "has no extents");
    extents_.resize(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0)
      check(H5Sget_simple_extent_dims(space_.get(), extents_.data(), nullptr), path_, name_, "has no extents");
    std::size_t count = numbers_.perRow;
    for (std::size_t axis = 0; axis < extents_.size(); ++axis) {
      count *= static_cast<std::size_t>(extents_[axis]);
      if (extents_[axis] == samples && (samplesAxis_ == none || !samplesFirst_)) samplesAxis_ = axis;
    }
    if (samplesAxis_ == none || count != samples * runs_)
      throw FileError(path_, name_, "has changed while it was read");
    present_ = bytes ? hdf5::presentAlong(numbers_.dataset.get(), samplesAxis_, *bytes) : samples;
  }

  // Run after run of samples [from, from + count); not-a-number where the file is cut off.
  void read(std::size_t from, std::size_t count) {
    const std::size_t whole = present_ > from ? std::min(count, present_ - from) : 0;
    if (whole > 0) readWhole(from, whole);
    if (whole == count) return;
    sorted_.assign(count * runs_, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t run = 0; whole > 0 && run < runs_; ++run)
      std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(run * whole), whole,
                  sorted_.begin() + static_cast<std::ptrdiff_t>(run * count));
    values_.swap(sorted_);
  }
  std::span<const double> run(std::size_t run, std::size_t count) const {
    return std::span(values_).subspan(run * count, count);
  }
  std::size_t runs() const { return runs_; }

 private:
  void readWhole(std::size_t from, std::size_t count) {
    std::vector<hsize_t> start(extents_.size(), 0), size = extents_;
    start[samplesAxis_] = from;
    size[samplesAxis_] = count;
    check(H5Sselect_hyperslab(space_.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), path_, name_,
          "cannot be read in parts");
    const hsize_t all = count * runs_ / numbers_.perRow;
    const Handle memory(H5Screate_simple(1, &all, nullptr), H5Sclose);
    values_.resize(count * runs_);
    check(
        H5Dread(numbers_.dataset.get(), numbers_.memory.get(), memory.get(), space_.get(), H5P_DEFAULT, values_.data()),
        path_, name_, ("cannot be read at sample " + std::to_string(from + 1)).c_str());
    if (runs_ == 1 || !samplesFirst_) return;
    sorted_.resize(values_.size());
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t run = 0; run < runs_; ++run) sorted_[run * count + i] = values_[i * runs_ + run];
    values_.swap(sorted_);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::string path_, name_;
  std::size_t runs_, samplesAxis_ = none, present_ = 0;
  bool samplesFirst_;
  hdf5::NumberSource numbers_;
  Handle space_;
  std::vector<hsize_t> extents_;
  std::vector<double> values_, sorted_;
};

}  // namespace

void sendHdf5Columns(ReaderArguments& arguments, const ByteSink& send) {
  const auto path = arguments.text();
  const std::size_t samples = arguments.number();
  const auto columns = takeColumns(arguments);
  const Handle file = hdf5::openTruncated(path);
  check(file.get(), path, "", "is not an HDF5 file, or a damaged one");
  std::error_code ignored;
  std::optional<std::size_t> bytes = std::filesystem::file_size(path, ignored);
  if (hdf5::missingBytes(file.get(), *bytes) == 0) bytes.reset();
  std::map<std::string, Dataset> datasets;
  std::size_t step = pieceSamples;
  for (const auto& column : columns) {
    datasets.try_emplace(column.path, file.get(), path, column, samples, bytes);
    step = std::min(step, std::max<std::size_t>(1, pieceValues / column.runs));
  }
  for (std::size_t from = 0; from < samples; from += step) {
    const std::size_t count = std::min(step, samples - from);
    for (auto& [name, dataset] : datasets) dataset.read(from, count);
    sendPiece(send, count, columns.size(),
              [&](std::size_t c) { return datasets.at(columns[c].path).run(columns[c].run, count); });
  }
  sendEnd(send);
}

ArrayTree listHdf5(const std::string& path) { return readHdf5(path, foreign()); }

std::unique_ptr<ArrayStream> streamHdf5(const std::string& path, const std::vector<ArrayColumn>& columns,
                                        std::size_t samples) {
  std::map<std::string, std::size_t> runs;
  for (const auto& column : columns) runs[column.path] = column.runs;
  ChildLimits limits;
  limits.memory = std::size_t{128} << 20;
  limits.seconds = 10;
  for (const auto& [name, count] : runs) {  // cache and pieces; ten times as long as honest files take
    limits.memory += (std::size_t{64} << 20) + 24 * std::min(pieceValues, count * pieceSamples);
    limits.seconds += samples / 2000000 * count;
  }
  ReaderCall call{"HDF5 columns"};
  putColumns(call.text(path).number(samples), columns);
  return std::make_unique<ColumnPieces>(path, columns.size(), limits, call);
}

}  // namespace squat::results
