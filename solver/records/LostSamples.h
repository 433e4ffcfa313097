// solver/records/LostSamples.h - rows that a logger has lost here and there.
#pragma once

#include <cstddef>
#include <vector>

#include "records/WorkRows.h"

namespace squat::records {

// Whether a clock keeps equal steps but for samples that are lost again and again: nine tenths of the steps within a
// fifth of their median, and more than one in ten thousand (at least three) two to four times as long, to a fifth of a
// step. Fewer are gaps, each for itself.
bool losesSamples(const std::vector<double>& steps, double median);

// Puts rows on straight lines where the time has made two to four steps at once, from row `from` on. Returns how many.
std::size_t bridgeLostSamples(WorkRows& rows, std::size_t from, double step);

}  // namespace squat::records
