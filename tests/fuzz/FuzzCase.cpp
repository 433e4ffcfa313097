// Case files (TOML): any text gives a case or an error of ours; what is read can be written and read again unchanged.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/Errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  cases::CaseDescription description;
  try {
    description = cases::parseCase({reinterpret_cast<const char*>(data), size}, "fuzz.toml", "/nonexistent");
  } catch (const CaseError&) {
    return 0;
  } catch (const FileError&) {
    return 0;
  }
  const auto text = cases::writeCase(description);
  if (cases::writeCase(cases::parseCase(text, "written.toml")) != text) std::abort();
  return 0;
}
