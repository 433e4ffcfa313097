// Profiles (CSV): any text gives ascending finite points or an error of ours, as it stands, filtered and cut; what a
// filter makes of the points is finite as well.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "case/ProfileFile.h"
#include "core/Errors.h"
#include "scenario/MeasuredProfile.h"

namespace {

void requireSound(const std::vector<squat::cases::ProfilePoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].position) || !std::isfinite(points[i].height)) std::abort();
    if (i > 0 && !(points[i].position > points[i - 1].position)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  for (const auto filter : {cases::ProfileFilter::none, cases::ProfileFilter::outliers, cases::ProfileFilter::median})
    try {
      cases::Defect asked;
      asked.filter = filter, asked.filterWidth = 0.005;
      const auto points = cases::parseProfile({reinterpret_cast<const char*>(data), size}, "fuzz.csv", asked);
      requireSound(points);
      requireSound(scenario::countedPoints(points, asked));
      for (const std::size_t apart : scenario::pointsApart(points))
        if (apart >= points.size()) std::abort();
      if (!std::isfinite(scenario::deepestPlace(points).depth)) std::abort();
    } catch (const FileError&) {
    }
  return 0;
}
