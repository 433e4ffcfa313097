// Long records (text, HDF5, MATLAB): any bytes give blocks of finite numbers with as many rows as channels, or an error
// of ours. Array files are read in a child process, whose death is an error too.
#include <cmath>

#include "MemoryFile.h"
#include "core/Errors.h"
#include "loggers/LoggerFile.h"
#include "readers/ArrayFile.h"
#include "records/RecordStream.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void judge(const squat::records::RecordBlock& block, std::size_t channels, std::size_t maximum) {
  require(block.size() > 0 && block.size() <= maximum);
  require(block.values.size() == channels && block.speed.size() == block.size());
  require(block.latitude.size() == block.longitude.size());
  for (const auto& row : block.values) {
    require(row.size() == block.size());
    for (const double value : row) require(std::isfinite(value));
  }
  for (const double position : block.position) require(std::isfinite(position));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  const std::string path = tests::memoryFile(data, size);
  records::RecordOptions options;
  options.columns.column = "all";
  options.columns.speed = 30;
  options.columns.signalUnit = "m/s2";
  options.blockLength = 64;  // so that short inputs have seams between blocks
  try {
    // A row of text takes a byte at least. Arrays may be packed or have no values: some suffice here.
    const bool isArray = readers::isArrayFile(path) || loggers::isPacked(path);
    constexpr std::size_t enough = 100'000;
    const auto stream = records::openRecord(path, options);
    records::RecordBlock block;
    std::size_t samples = 0;
    while ((!isArray || samples < enough) && stream->next(block)) {
      judge(block, stream->layout().channels.size(), options.blockLength);
      samples += block.size();
      require(isArray || samples <= size);
    }
    for (const auto& fault : stream->faults()) require(fault.first <= fault.end && !fault.text.empty());
  } catch (const FileError&) {
  } catch (const CaseError&) {
  }
  return 0;
}
