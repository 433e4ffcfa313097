// widgets/studio/profile/ShapeHandles.h - which places of a defect can be pulled with the mouse, and what that changes.
// No windows here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::studio {

// A place on the curve of an analytic shape that moves with one key of the case.
struct ShapeHandle {
  std::string key;         // defect.depth, defect.length
  cases::ProfilePoint at;  // [m] from the deepest point, as ProfileView
  bool isVertical = true;  // else along the rail
  double rate = 0;         // [m] that it moves when the key grows by its unit
};

// The deepest point and both ends; none for sampled profiles, whose points can be dragged, and for smooth rail.
std::vector<ShapeHandle> shapeHandles(const cases::CaseDescription& description);

// The curve at this position [m]: it follows the mouse up and down. Nothing where the depth does not move it.
std::optional<ShapeHandle> handleOnCurve(const cases::CaseDescription& description, double position);

// The case in which the handle is at `to`, or as near to it as the limits of its key allow. The key has four digits, as
// its slider gives them.
cases::CaseDescription pulled(const cases::CaseDescription& description, const ShapeHandle& handle,
                              const cases::ProfilePoint& to);

// The point `index` moved to `to`. Points within `radius` [m] of it are raised or lowered by the same way times
// cos^2(pi / 2 * distance / radius). Both ends stay where they join the smooth rail.
std::vector<cases::ProfilePoint> pulledPoints(std::vector<cases::ProfilePoint> points, std::size_t index,
                                              const cases::ProfilePoint& to, double radius);

}  // namespace squat::studio
