// solver/detection/Example.h - a passage whose cause is known.
#pragma once

#include <array>
#include <string>

#include "detection/EventFeatures.h"
#include "detection/Severity.h"

namespace squat::detection {

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
};

}  // namespace squat::detection
