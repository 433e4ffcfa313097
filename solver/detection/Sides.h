// solver/detection/Sides.h - the events of the two axle boxes of a wheelset as events of the rails.
#pragma once

#include "detection/AxleSides.h"
#include "detection/Detect.h"

namespace squat::detection {

// Gives each judged event of a wheelset with two channels its side. Of two events within 0.3 m, one on each channel,
// one is crosstalk and is left out where the side is left or right with 80 % at least, and it does not say as surely
// that it is of its own rail. What is labelled stays, and speaks for both.
void judgeSides(RecordDetection& detection, const AxleSides& sides);

}  // namespace squat::detection
