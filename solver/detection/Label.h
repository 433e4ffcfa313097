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
  double length = 0, depth = 0;      // [m] of a squat, as measured on site; 0: not known
  std::optional<Severity> severity;  // of a squat, where it is given; else it follows from length and depth

  bool hasSize() const { return kind == Kind::squat && length > 0 && depth > 0; }
  // Of a squat; nothing where it is not known.
  std::optional<Severity> severityBy(const SeverityLimits& limits) const {
    if (kind != Kind::squat || severity || !hasSize()) return severity;
    return severityOf(length, depth, limits);
  }
};

}  // namespace squat::detection
