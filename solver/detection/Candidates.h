// solver/detection/Candidates.h - where a record is louder than around.
#pragma once

#include <cstddef>
#include <vector>

#include "detection/BandPower.h"

namespace squat::detection {

// Evidence against "noise as around" at each cell: the logarithm of the generalised likelihood ratio for a larger
// variance, summed over the bands,
//   sum_b  n_b / 2 (r_b - 1 - ln r_b)  where r_b = power / level > 1,
// n_b the degrees of freedom of the smoothed power. Powers are smoothed over the time that an impact rings.
struct Evidence {
  std::vector<std::vector<double>> level;  // [unit^2] of each band at each cell
  std::vector<double> value;               // at each cell
};

// `speed` [m/s] at each cell. There is no evidence where the channel is `silent` (a row of cells; empty: nowhere), and
// what is there does not count in the level.
Evidence evidenceOf(const BandPower& power, double rate, const std::vector<double>& speed,
                    const std::vector<bool>& silent = {});

// The cell in [first, end) where the impact is: an impact excites all bands at once, what rings behind it does not. The
// first that reaches 0.8 of the largest sum over the bands above 320 Hz of ln(1 + power / floor), each floor the level
// or, where that is larger, a thirtieth of the band's largest power there. `level` as in Evidence.
std::size_t anchorIn(const BandPower& power, const std::vector<std::vector<double>>& level, std::size_t first,
                     std::size_t end);

struct Candidate {
  std::size_t first = 0, end = 0;  // cells [first, end) above a third of the threshold
  std::size_t anchor = 0;          // anchorIn() the 24 ms around the largest evidence
  double score = 0;                // largest evidence
};

// Stretches that reach the threshold; those less than `gap` [m] apart are one. `travelled` [m]: distance along the
// record at each cell.
std::vector<Candidate> candidatesIn(const BandPower& power, const Evidence& evidence,
                                    const std::vector<double>& travelled, double threshold, double gap = 0.25);

}  // namespace squat::detection
