// widgets/studio/signals/FigureTable.h - what a figure shows, as numbers.
#pragma once

#include <QByteArray>

#include "plots/Figure.h"

namespace squat::studio {

// CSV with a header of short names with their unit: curves one below the other (name, x, y), as they need not share
// their x; a coloured map as its cells (name, x, y, value). Only what lies within the x axis as it is zoomed.
QByteArray figureTable(plots::Figure& figure);

// Where a cell of a coloured map lies on the axes. Cells are even on the screen, on a logarithmic axis as well.
QPointF cellLocation(const QCPColorMap& map, int column, int row);

}  // namespace squat::studio
