// libFuzzer program: any bytes as a profile. What is taken must make a finite surface.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "case/DefectSurface.h"
#include "case/ParameterTable.h"
#include "case/PointsText.h"
#include "case/ProfileFile.h"
#include "core/Errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  try {
    cases::Defect defect = cases::defaultCase().defect;
    defect.shape = static_cast<int>(cases::DefectShape::profile);
    defect.points = cases::parseProfile({reinterpret_cast<const char*>(data), size}, "fuzz.csv");
    if (!cases::pointsMistake(defect.points).empty()) std::abort();
    for (const bool level : {true, false}) {
      defect.level = level;
      const cases::DefectSurface surface(defect);
      for (const double x : {surface.first(), surface.last(), 0.0, 0.5 * surface.first(), 0.01})
        if (!std::isfinite(surface.height(x)) || !std::isfinite(surface.slope(x))) std::abort();
      if (!std::isfinite(surface.dipLength()) || !std::isfinite(surface.steepest())) std::abort();
    }
  } catch (const FileError&) {
  }
  return 0;
}
