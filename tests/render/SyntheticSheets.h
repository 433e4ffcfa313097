// tests/render/SyntheticSheets.h - every figure of the signal analysis, from made-up signals, runs and a study.
#pragma once

#include <vector>

#include "plots/FigureSheet.h"

namespace squat::tests {

// Two repeated runs analysed (histories, densities, short-time transforms, scalograms, scatter bands), a comparison
// with a measured signal and one with smooth track, a study over two keys, the seven figures of the paper.
std::vector<plots::FigureSheet> syntheticSheets();

}  // namespace squat::tests
