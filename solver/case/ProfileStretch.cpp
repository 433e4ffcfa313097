#include "case/ProfileStretch.h"

#include "scenario/MeasuredProfile.h"
#include "text/Numbers.h"

namespace squat::cases {

// A run starts 0.3 m before the defect unless the case says otherwise.
std::string stretchAdvice(const std::vector<ProfilePoint>& points) {
  constexpr double half = 0.25;  // [m]
  const auto deepest = scenario::deepestPlace(points);
  const auto metres = [](double position) { return text::fixedText(position, 3); };
  return "Its deepest place, " + text::roundedText(1e3 * deepest.depth) + " mm below the level about it, is at " +
         metres(deepest.position) + " m: set defect.from = " + metres(deepest.position - half) +
         " and defect.to = " + metres(deepest.position + half) + ", or another stretch";
}

}  // namespace squat::cases
