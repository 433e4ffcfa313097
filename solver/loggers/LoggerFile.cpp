#include "loggers/LoggerFile.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/DurableFile.h"
#include "loggers/GzipText.h"
#include "loggers/LabviewFile.h"
#include "loggers/SeismicList.h"
#include "loggers/TdmsFile.h"
#include "loggers/UniversalFile.h"
#include "loggers/WavFile.h"

namespace squat::loggers {
namespace {

constexpr std::size_t largestUnpacked = std::size_t{4} << 30;

// Empty for what is no regular file: a named pipe must not hold the program.
std::string beginningOfLogger(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::ifstream in(path, std::ios::binary);
  std::string head(4096, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

}  // namespace

bool isLoggerFile(const std::string& path) {
  const auto head = beginningOfLogger(path);
  return isTdmsFile(head) || isLabviewFile(head) || isWavFile(head) || isUniversalFile(head) || isSeismicList(head);
}

LoggerTable readLoggerFile(const std::string& path, const std::string& object) {
  const auto head = beginningOfLogger(path);
  if (isTdmsFile(head)) return readTdmsFile(path, object);
  if (isLabviewFile(head)) return readLabviewFile(path);
  if (isWavFile(head)) return readWavFile(path);
  if (isSeismicList(head)) return readSeismicList(path);
  return readUniversalFile(path);
}

bool isPacked(const std::string& path) { return isGzip(beginningOfLogger(path)); }

std::string unpackedText(const std::string& path) {
  return unpacked(readWholeFile(path, largestUnpacked), path, largestUnpacked);
}

}  // namespace squat::loggers
