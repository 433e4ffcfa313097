// widgets/plots/LegendRows.h - a legend in as many rows as its names need.
#pragma once

#include "plots/PlotLibrary.h"

namespace squat::plots {

// One row where all names fit into `width` [units of the figure], else further rows. A name that is longer than a whole
// row is shortened in its middle, because names of runs differ at their ends. Names of hidden curves are dimmed towards
// `ground`, the colour behind them.
void fitLegend(QCPLegend& legend, int width, const QColor& ground);

}  // namespace squat::plots
