// solver/calibration/StatementResiduals.h - statements as numbers that a search can make small.
#pragma once

#include <map>
#include <string>

#include "calibration/TargetValue.h"
#include "calibration/Targets.h"
#include "results/RunResult.h"

namespace squat::calibration {

// Where a number stands in the range of a statement: 0 at the expected number (or the middle), +-1 at the limits. A
// range with one limit: 1 at the limit, 0 from a quarter of it inside.
double statementResidual(const statements::Statement& statement, double value);

// One value for each statement, by the judge of the paper's statements.
std::vector<TargetValue> statementValues(const Targets& targets,
                                         const std::map<std::string, results::RunResult>& results,
                                         const std::string& mesh);

}  // namespace squat::calibration
