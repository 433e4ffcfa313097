// widgets/plots/MapComparison.h - two signals as maps over position and frequency, side by side.
#pragma once

#include <string>
#include <vector>

#include "plots/FigureSheet.h"
#include "signals/Comparison.h"

namespace squat::plots {

enum class MapKind { scalogram, shortTime };

// (a) the first signal and (b) the second in the colours of one scale; (c) 10 log10 of (first + f) / (second + f) in
// dB, where f is a thousandth of the largest power that is seen: what is faint in both is white, and what lies above
// half the lower sampling rate. Over position or time, as the comparison is. Throws SignalError where the signals are
// too short for the map.
FigureSheet mapComparison(const signals::Comparison& comparison, MapKind kind, const std::string& name,
                          const Style& style);

}  // namespace squat::plots
