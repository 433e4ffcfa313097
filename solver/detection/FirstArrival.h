// solver/detection/FirstArrival.h - which of the two axle boxes of a wheelset moves first, and by how much more.
//
// A wheel that strikes shakes its own axle box at once. The other one moves when a wave has crossed axle or sleepers:
// 0.3 ms at the speed of sound in steel, some three times as long in bending. Within a few milliseconds both are as
// loud.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "signals/TimeSeries.h"

namespace squat::detection {

// [Hz] Below it, what arrives first and what arrives a millisecond later are too few samples apart.
inline constexpr double lowestRateOfArrivals = 4000;

// Of the two boxes, in the order in which they were given.
struct FirstArrival {
  std::array<double, 2> energy{};  // [m2/s3] over the first 1.5 ms of what either of them feels, noise included
  std::array<double, 2> noise{};   // [m2/s3] of as long a stretch of the noise ahead
};

// Signals of one time axis. What they feel is looked for from 0.15 m ahead of the sample `anchor` to 0.1 m behind it,
// at `speed` [m/s]. Nothing where the record does not reach that far, or a box keeps one value.
std::optional<FirstArrival> firstArrival(const signals::TimeSeries& one, const signals::TimeSeries& other,
                                         std::size_t anchor, double speed);

}  // namespace squat::detection
