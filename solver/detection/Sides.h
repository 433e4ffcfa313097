// solver/detection/Sides.h - the events of the two axle boxes of a wheelset as events of the rails.
#pragma once

#include "detection/AxleSides.h"
#include "detection/Detect.h"

namespace squat::detection {

// Gives each judged event of a wheelset with two channels its side. Of two events within 0.3 m, one on each channel, the
// stronger decides for both; unless both rails have a defect, that of the other rail is crosstalk and is removed. What
// is labelled stays.
void judgeSides(RecordDetection& detection, const AxleSides& sides);

}  // namespace squat::detection
