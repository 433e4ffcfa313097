// solver/detection/LocalLevel.h - what the power of a band is where nothing happens.
#pragma once

#include <cstddef>
#include <vector>

namespace squat::detection {

// Mean of each value's neighbourhood of `width` cells (fewer at the ends).
std::vector<double> smoothed(const std::vector<double>& values, std::size_t width);

// The level around each cell: medians over windows of 2 `half` cells, a straight line between them. A median does not
// see events that fill less than half of its window. `freedom` is the number of independent values in each of the
// (smoothed) values: it gives the mean of noise that has this median, 1 / (1 - 2 / (9 freedom))^3 of it (Wilson and
// Hilferty 1931). Zero only where half of a window is. Cells that are `silent` (a dead channel) count nowhere; empty:
// none is.
std::vector<double> localLevel(const std::vector<double>& values, std::size_t half, double freedom,
                               const std::vector<bool>& silent = {});

}  // namespace squat::detection
