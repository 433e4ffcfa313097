// widgets/studio/profile/ShapeHandles.h - what of a defect can be pulled with the mouse. No windows here.
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

// The case in which the handle is at `to`, as near as its key allows; four digits of the key, as its slider gives.
cases::CaseDescription pulled(const cases::CaseDescription& description, const ShapeHandle& handle,
                              const cases::ProfilePoint& to);

// A point that is dragged takes along the heights of those within `radius` [m]: all of the way where it is, none of it
// at the radius, smoothly between (a squared cosine). Both ends stay where they join the smooth rail.
std::vector<cases::ProfilePoint> pulledPoints(std::vector<cases::ProfilePoint> points, std::size_t index,
                                              const cases::ProfilePoint& to, double radius);

}  // namespace squat::studio
