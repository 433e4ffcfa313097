// solver/results/PatchCells.h - the part of the running surface that each point of a contact patch stands for.
#pragma once

#include <vector>

#include "results/RunResult.h"

namespace squat::results {

struct PatchCell {
  double left = 0, right = 0;  // [m] along the rail, from the wheel centre
  double near = 0, far = 0;    // [m] across the rail
};

// One cell a point, in the order of the points. They fill the patch without gaps: a border lies half-way between
// neighbouring columns or rows of points, outermost cells are as wide on their outer side as on their inner one.
// A point without neighbours has a square of its own area. Empty where the patch has no places.
std::vector<PatchCell> patchCells(const PatchSnapshot& patch);

}  // namespace squat::results
