// widgets/studio/signals/PeakMarks.h - the peaks of a figure of a signal, marked and named.
#pragma once

#include "plots/Figure.h"

namespace squat::studio {

// A ring at the largest and at the smallest value of the first curve within the x axis, each with value and place in
// the unit of the axis ("94 at 12.3 mm").
void markExtremes(plots::Figure& figure, const QString& unit);

// Rings at the strongest lines of the figure's coloured map (at most three, each at least a tenth of the strongest),
// named by frequency and place.
void markLines(plots::Figure& figure, const QString& unit);

}  // namespace squat::studio
