// Spectra of an irregularity: any text gives a table that a case takes, or an error of ours.
#include <cstdint>
#include <cstdlib>

#include "case/LevelsText.h"
#include "core/Errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    if (!cases::levelsMistake(cases::parseLevelsTable(text, "fuzz.csv")).empty()) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
