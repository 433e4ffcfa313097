// solver/contact/WearLaw.h - the depth that friction takes off a point of the rail.
//
// Depth per distance rolled over the frictional work per area and distance rolled, w = tau s / v [Pa], which is T gamma
// over the area at a single point: slope w below firstLimit, constant up to secondLimit, steeper beyond. Archard's law,
// volume = k load sliding / hardness, is the first branch alone: sliding points carry tau = mu p, so the depth rate
// k p s / H is k / (mu H) times their power tau s.
#pragma once

#include <algorithm>
#include <limits>

namespace squat::scenario {
struct Scenario;
}

namespace squat::contact {

struct WearLaw {
  double slope = 0;                                              // [m3/J]
  double firstLimit = std::numeric_limits<double>::infinity();   // [Pa]
  double secondLimit = std::numeric_limits<double>::infinity();  // [Pa]
  double steeper = 0;                                            // [m3/J]
};

// [m] of depth per metre rolled.
inline double wearDepth(const WearLaw& law, double work) {
  return law.slope * std::min(work, law.firstLimit) + law.steeper * std::max(0.0, work - law.secondLimit);
}

WearLaw wearLawOf(const scenario::Scenario& scenario);

}  // namespace squat::contact
