#include "PlayLogger.h"
#include "loggers/WavFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  return tests::playLogger(loggers::parseWavFile, loggers::isWavFile, data, size);
}
