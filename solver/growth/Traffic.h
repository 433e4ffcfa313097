// solver/growth/Traffic.h - the wheelsets that stand for the traffic on the rail.
#pragma once

#include <vector>

#include "case/CaseDescription.h"

namespace squat::growth {

// What one of them differs in from the wheelset of the case.
struct Draw {
  double lateral = 0;   // [m] of the touching point along the crown
  double load = 1;      // times the sprung mass
  double speed = 1;     // times the speed
  double traction = 0;  // torque over wheel load times radius, in place of the case's
};

// Latin hypercube of growth.wheelsets normal draws: each quantity takes the mean of each of so many equally likely
// strata once, scaled to the standard deviation asked for; which goes with which is drawn with growth.seed.
std::vector<Draw> drawTraffic(const scenario::Growth& growth);

// The case of one of them.
cases::CaseDescription withDraw(cases::CaseDescription description, const Draw& draw);

// [kg] that the axle of such a case puts on both rails.
double axleMass(const cases::CaseDescription& description);

}  // namespace squat::growth
