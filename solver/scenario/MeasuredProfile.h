// solver/scenario/MeasuredProfile.h - measured points before they are a surface: the stretch that counts, what stands
// apart, and filters. Positions ascend.
#pragma once

#include <cstddef>
#include <vector>

#include "scenario/Defect.h"

namespace squat::scenario {

// The points from defect.from to defect.to (all of them where both are equal), filtered as defect.filter says, over
// windows of defect.filterWidth about each point:
//   outliers  a point further than three standard deviations from the median of its window becomes that median; the
//             deviation is 1.4826 times the median of the absolute ones, as of normal noise (Hampel, J. Am. Stat.
//             Assoc. 69, 1974). Windows of fewer than five points change nothing.
//   median    the same, then each point is the median of its window, while the line between the medians at both ends is
//             taken off, so that straight lines stay what they are. A crest or a bottom of curvature c loses
//             c width^2 / 32.
std::vector<ProfilePoint> countedPoints(const std::vector<ProfilePoint>& points, const Defect& defect);

// The points that stand off both neighbours as only measuring errors do, the farthest first: by ten standard deviations
// (as above, of seven points or of the whole profile, 1 um at least) from the median of the seven points about it. None
// of fewer than seven points.
std::vector<std::size_t> pointsApart(const std::vector<ProfilePoint>& points);

// Where a long scan lies deepest below the mean of the 0.5 m about each place [m], and how far [m, positive]; single
// points do not count. {0, 0} for no points.
struct DeepestPlace {
  double position = 0, depth = 0;
};
DeepestPlace deepestPlace(const std::vector<ProfilePoint>& points);

// The median distance between points [m]; 0 for fewer than two.
double typicalStep(const std::vector<ProfilePoint>& points);

}  // namespace squat::scenario
