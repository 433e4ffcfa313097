#include "PlayLogger.h"
#include "loggers/UniversalFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  return tests::playLogger(loggers::parseUniversalFile, loggers::isUniversalFile, data, size);
}
