// solver/estimation/ModelSpread.h - what else the depth could be if the wheelset is another than the case's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimation/Estimation.h"
#include "estimation/ProfileRuns.h"
#include "estimation/Residuals.h"

namespace squat::estimation {

// One of the shipped wheelsets in place of the case's.
struct OtherWheelset {
  std::string name;
  double factor = 1;  // on all heights, with which this wheelset explains the record best
};

// What the search needs to repeat itself with another case.
struct SpreadQuestion {
  const EstimateDefinition& definition;
  const EstimateOptions& options;
  SearchWindow window;
  std::vector<double> speeds;  // [m/s] of the models
  const std::vector<ComparedPassage>& passages;
};

// Factors of all shipped wheelsets that differ from the case's. Nothing where it was cancelled; a wheelset with which
// the case cannot be run is left out.
std::optional<std::vector<OtherWheelset>> otherWheelsets(const SpreadQuestion& question, const ProfilePoints& points,
                                                         int& runs, Monitor& monitor);

}  // namespace squat::estimation
