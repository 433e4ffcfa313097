// solver/detection/Label.h - what the user has seen on site of one event.
#pragma once

#include <optional>
#include <string>

#include "detection/Severity.h"

namespace squat::detection {

struct Label {
  double position = 0;  // [m]
  std::string channel;  // empty: any
  Kind kind = Kind::squat;
  double length = 0, depth = 0;      // [m] of a squat; 0: not known
  std::optional<Severity> severity;  // of a squat, where it is given; else it follows from length and depth
};

}  // namespace squat::detection
