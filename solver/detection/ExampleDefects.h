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
  double support = 1;             // [-] share of its stiffness that the ballast has below the two sleepers beside it

  SquatForm form() const;
};

// Squats: cosine, W shape and dips with trailing waves, 12 to 95 mm long and 0.03 to 0.5 mm deep, spread evenly over
// the logarithms of both, a third of each severity. Dips deeper than a wheel of 0.46 m can follow by more than a half
// are left out: no signal tells them from shallower ones.
std::vector<ExampleDefect> exampleSquats(std::size_t count, std::uint32_t seed);

// In turn, an eighth of each but for joints and welds, which have two:
//   joint        gap 5 to 20 mm, ends that meet at 5 to 20 mrad over 60 to 560 mm, one up to 0.3 mm
//                higher, worn behind the gap; two of five on sleepers whose ballast has 15 to 60 % of its stiffness
//   insulated    a joint as well: filled gap 4 to 8 mm, 1 to 6 mrad, one of five on such sleepers
//   weld         dip or hump, smooth or peaked: 0.1 to 1 m, and 20 to 100 mm, slopes of 1 to 10 mrad, up to 0.5 mm
//   crossing     kind other: 5 to 20 mrad over 0.12 to 0.5 m and a worn nose
//   corrugation  3 to 20 waves of 25 to 80 mm, no longer than 1.2 m, 0.02 to 0.12 mm from crest to valley
//   squats       two or three of 20 to 70 mm, 60 to 290 mm from middle to middle; length and depth are those of the
//   deepest
// Dimensions are assumed from what railways tolerate and repair; none comes from a measurement. Joints have no bars.
std::vector<ExampleDefect> exampleOthers(std::size_t count, std::uint32_t seed);

// Flats of the wheel, kind flat: chords of 15 to 60 mm, fresh or worn round to twice that. `defect` is the deviation of
// the tread; the path of a rigid wheel is that over the same heights of the rail, but for (s/R)^2/6 of the length.
std::vector<ExampleDefect> exampleFlats(std::size_t count, std::uint32_t seed);

}  // namespace squat::detection
