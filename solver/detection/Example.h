// solver/detection/Example.h - a passage whose cause is known.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "detection/EventFeatures.h"
#include "detection/Severity.h"
#include "scenario/Defect.h"

namespace squat::detection {

// What a squat has beside length and depth, DefectSurface.h. Labels and older tables do not know it: `none`.
struct SquatForm {
  scenario::DefectShape shape = scenario::DefectShape::none;
  double middleHeight = 0;                              // [-]
  double waveLength = 0, waveDepth = 0, waveCount = 0;  // [m], [m], [-]
};

inline constexpr double leastWeight = 1e-9;  // of an example

// One passage without noise, computed by the solver or labelled by the user.
struct Example {
  Kind kind = Kind::squat;
  std::string vehicle;           // examples of one vehicle on one track share it
  double length = 0, depth = 0;  // [m] of a squat; 0: not known
  double speed = 0;              // [m/s]
  double offset = 0;             // [m] from the defect's deepest point to the event's anchor
  double weight = 1;
  std::array<double, bandCount> energy{};  // [m2/s3] in the event's window
  double before = 0, reach = 0;            // as in EventFeatures
  SquatForm form;                          // of a squat
  // [m2/s3] FirstArrival's energies of this side and the other, of a defect on one rail alone; nothing: not known.
  std::optional<std::array<double, 2>> arrival = {};
};

}  // namespace squat::detection
