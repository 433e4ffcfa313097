// widgets/plots/ShownStretch.h - the stretch of track around the impact that figures show, the one that runs are judged
// by.
#pragma once

namespace squat::plots {

inline constexpr double shownBefore = 0.1, shownAfter = 0.28;  // [m] from the impact

}  // namespace squat::plots
