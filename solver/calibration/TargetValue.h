// solver/calibration/TargetValue.h - how one point of the search stands to one target.
#pragma once

#include <optional>
#include <vector>

namespace squat::calibration {

struct TargetValue {
  // Statement: the number that is judged, in its unit. Data: root mean square of the residuals, in units of what a
  // residual is allowed (noise, tolerance). None: cannot be determined.
  std::optional<double> value;
  bool isMet = false;
  double misfit = 0;              // what the search makes small; 1 at the limit of the range, or at the noise
  std::vector<double> residuals;  // dimensionless; statement: one, +-1 at the limits; data: independent samples
};

// Of a statement that cannot be determined: three half widths outside its range.
inline constexpr double kMissingResidual = 3;

}  // namespace squat::calibration
