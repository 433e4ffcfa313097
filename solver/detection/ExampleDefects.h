// solver/detection/ExampleDefects.h - irregularities of the rail of which examples are computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "detection/Example.h"
#include "scenario/Defect.h"

namespace squat::detection {

struct ExampleDefect {
  Kind kind = Kind::squat;
  double length = 0, depth = 0;  // [m]
  scenario::Defect defect;
  double before = 0, behind = 0;  // [m] that it reaches from its deepest point

  SquatForm form() const;
};

// Squats: cosine, W shape and dips with trailing waves, 12 to 95 mm long and 0.03 to 0.5 mm deep, spread evenly over
// the logarithms of both, a third of each severity. Dips deeper than a wheel of 0.46 m can follow by more than a half
// are left out: no signal tells them from shallower ones.
std::vector<ExampleDefect> exampleSquats(std::size_t count, std::uint32_t seed);

// Half joints, half welds.
//   joint  a gap of 5 to 9 mm, rail ends that dip to it by 0.1 to 0.8 mm over 120 to 350 mm, a step up to 0.2 mm
//   weld   a smooth dip or hump of 120 to 600 mm and 0.08 to 0.4 mm, with a waviness of up to 0.03 mm inside
// Dimensions from memory of what railways tolerate; unverified.
std::vector<ExampleDefect> exampleJointsAndWelds(std::size_t count, std::uint32_t seed);

}  // namespace squat::detection
