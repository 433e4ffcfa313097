#include "readers/ArrayFile.h"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

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

}  // namespace

bool isArrayFile(const std::string& path) { return isHdf5(path) || results::isMatlabFile(path); }

results::ArrayTree readArrays(const std::string& path) {
  if (results::isMatlabFile(path) && !isHdf5(path)) return results::readMatlabFile(path);
  results::Hdf5Limits limits;
  limits.skipForeign = true;
  return results::readHdf5(path, limits);
}

results::ArrayTree listArrays(const std::string& path) {
  return results::isMatlabFile(path) && !isHdf5(path) ? results::listMatlabFile(path) : results::listHdf5(path);
}

std::unique_ptr<results::ArrayStream> streamArrays(const std::string& path,
                                                   const std::vector<results::ArrayColumn>& columns,
                                                   std::size_t samples) {
  return results::isMatlabFile(path) && !isHdf5(path) ? results::streamMatlabFile(path, columns, samples)
                                                      : results::streamHdf5(path, columns, samples);
}

}  // namespace squat::readers
