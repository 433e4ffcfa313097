// solver/calibration/SpaceFilling.h - points that fill a unit cube evenly, however many are taken.
#pragma once

#include <cstddef>
#include <vector>

namespace squat::calibration {

// Point `index` (from 0) of the additive recurrence by the powers of 1/g, g the positive root of g^(d+1) = g + 1: the
// generalised golden ratio (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018). The first n
// points are the same whatever n.
std::vector<double> spaceFillingPoint(std::size_t index, std::size_t dimensions);

}  // namespace squat::calibration
