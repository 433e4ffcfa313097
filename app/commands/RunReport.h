// app/commands/RunReport.h - a run as one JSON object, for programs that read what `squat run` prints.
#pragma once

#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::commands {

// Schema "squat-run": version and commit, case, files written, features (names as for --features), energies at the end,
// equilibrium, mesh and performance. Every number stands with its unit as {"value": 1, "unit": "s"}; null: not a
// number. A record too short for features has none.
std::string runReport(const results::RunResult& result, const std::vector<std::string>& files);

}  // namespace squat::commands
