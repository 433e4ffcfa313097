// libFuzzer program: any bytes as a case file. Taken or refused with an error of the user, never anything else; what is
// taken must be valid and must read back as it is written.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "case/CaseFile.h"
#include "case/Validation.h"
#include "core/Errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    const auto description =
        cases::parseCase({reinterpret_cast<const char*>(data), size}, "fuzz.toml", "/nonexistent");
    if (!cases::validate(description).problems.empty()) std::abort();
    const std::string written = cases::writeCase(description);
    if (cases::writeCase(cases::parseCase(written, "written.toml")) != written) std::abort();
  } catch (const CaseError&) {
  } catch (const FileError&) {
  }
  return 0;
}
