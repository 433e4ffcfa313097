#include "PlayLogger.h"
#include "loggers/SeismicList.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  return tests::playLogger(loggers::parseSeismicList, loggers::isSeismicList, data, size);
}
