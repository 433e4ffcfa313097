#include "readers/ArrayFile.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/Errors.h"
#include "results/Hdf5.h"
#include "results/Hdf5Stream.h"
#include "results/MatlabFile.h"

namespace squat::readers {
namespace {

// The signature stands at the beginning, or behind a user block of 512, 1024, ... bytes (MATLAB writes one).
bool isHdf5(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;  // a named pipe must not hold the program
  std::ifstream in(path, std::ios::binary);
  for (std::streamoff offset = 0; in && offset <= 65536; offset = offset ? offset * 2 : 512) {
    char head[8] = {};
    in.seekg(offset);
    in.read(head, 8);
    if (in.gcount() == 8 && std::string_view(head, 8) == "\x89HDF\r\n\x1a\n") return true;
  }
  return false;
}

// netCDF before version 4 is a format of its own.
bool isClassicNetCdf(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream in(path, std::ios::binary);
  char head[4] = {};
  in.read(head, 4);
  return in.gcount() == 4 && std::string_view(head, 3) == "CDF" && (head[3] == 1 || head[3] == 2 || head[3] == 5);
}

void requireRead(const std::string& path) {
  if (isClassicNetCdf(path))
    throw FileError(path, "", "is a netCDF file of the classic format, which is not read",
                    "Write it as netCDF 4, which is HDF5: nccopy -k netCDF-4 in.nc out.nc");
}

class UnpackedStream : public results::ArrayStream {
 public:
  UnpackedStream(std::unique_ptr<results::ArrayStream> stored, const std::vector<results::ArrayColumn>& columns)
      : stored_(std::move(stored)) {
    for (const auto& column : columns) packings_.push_back(column.packing);
  }
  bool next(std::vector<std::vector<double>>& columns) override {
    std::vector<std::size_t> before(packings_.size());
    for (std::size_t c = 0; c < std::min(before.size(), columns.size()); ++c) before[c] = columns[c].size();
    const bool more = stored_->next(columns);
    for (std::size_t c = 0; c < std::min(before.size(), columns.size()); ++c)
      if (!packings_[c].isNone())
        for (std::size_t i = before[c]; i < columns[c].size(); ++i)
          columns[c][i] = results::unpacked(columns[c][i], packings_[c]);
    return more;
  }

 private:
  std::unique_ptr<results::ArrayStream> stored_;
  std::vector<results::Packing> packings_;
};

}  // namespace

bool isArrayFile(const std::string& path) {
  return isHdf5(path) || results::isMatlabFile(path) || isClassicNetCdf(path);
}

results::ArrayTree readArrays(const std::string& path) {
  requireRead(path);
  if (results::isMatlabFile(path) && !isHdf5(path)) return results::readMatlabFile(path);
  results::Hdf5Limits limits;
  limits.skipForeign = true;
  return results::readHdf5(path, limits);
}

results::ArrayTree listArrays(const std::string& path) {
  requireRead(path);
  return results::isMatlabFile(path) && !isHdf5(path) ? results::listMatlabFile(path) : results::listHdf5(path);
}

std::unique_ptr<results::ArrayStream> streamArrays(const std::string& path,
                                                   const std::vector<results::ArrayColumn>& columns,
                                                   std::size_t samples) {
  auto stored = results::isMatlabFile(path) && !isHdf5(path) ? results::streamMatlabFile(path, columns, samples)
                                                             : results::streamHdf5(path, columns, samples);
  const bool packed = std::any_of(columns.begin(), columns.end(), [](const auto& c) { return !c.packing.isNone(); });
  return packed ? std::make_unique<UnpackedStream>(std::move(stored), columns) : std::move(stored);
}

}  // namespace squat::readers
