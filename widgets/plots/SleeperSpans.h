// widgets/plots/SleeperSpans.h - where the sleepers lie along the track.
#pragma once

#include <vector>

#include "results/RunResult.h"

namespace squat::plots {

struct Span {
  double from = 0, to = 0;  // [m]
};

// Stretches along x that the part named "sleepers" of the surface covers, in order; empty where there is none.
std::vector<Span> sleeperSpans(const results::SurfaceMesh& surface);

}  // namespace squat::plots
