// solver/estimation/Residuals.h - computed beside measured acceleration, location by location.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/PassageFiles.h"
#include "estimation/PassageModel.h"

namespace squat::estimation {

// One passage as the search sees it.
struct ComparedPassage {
  std::size_t model = 0;          // which of the models computes it: passages at one speed share one
  PositionSeries measured;        // over the record's own position, around the event
  double noise = 0;               // [m/s2]
  std::vector<double> locations;  // [m] in the frame of the search; independent: two a period of the cut-off frequency
};

ComparedPassage comparedPassage(const MeasuredPassage& measured, std::size_t model, double modelSpeed, double cutoff,
                                const SearchWindow& window);

// [m] by which the record has to be read farther along its own axis: where both correlate best.
double shiftOf(const ComparedPassage& passage, const PositionSeries& computed);

std::vector<double> valuesAt(const PositionSeries& series, const std::vector<double>& locations, double shift);

// Computed less measured over the noise, at all locations, zero where the record does not reach; and their derivative
// by the shift [1/m].
Eigen::VectorXd residualsOf(const ComparedPassage& passage, const PositionSeries& computed, double shift);
Eigen::VectorXd slopeOfShift(const ComparedPassage& passage, double shift);

}  // namespace squat::estimation
