// solver/estimation/StartProfile.h - where the search starts: the dip of a few lengths and shapes that comes nearest.
#pragma once

#include <vector>

#include "estimation/ProfileRuns.h"
#include "estimation/Residuals.h"

namespace squat::estimation {

struct Dip {
  cases::DefectShape shape = cases::DefectShape::cosine;
  double length = 0, depth = 0;  // [m]
};

struct Start {
  Dip dip;
  std::vector<double> shifts;  // [m] of each passage
  double misfit = 0;           // sum of squares of all residuals
};

// Height of a dip whose middle stands at zero [m].
double heightOf(const Dip& dip, double position);

// Lengths from the shortest that the band shows to `longest` [m]; each at two depths, the second from the amplitude of
// the first, then other shapes of the best one. Nothing where it was cancelled. Throws RunError where none can be run.
std::optional<Start> findStart(ProfileRuns& runs, const std::vector<ComparedPassage>& passages,
                               const SearchWindow& window, double longest);

}  // namespace squat::estimation
