// Stands in until solver/simulation brings runCase.
#include "core/Errors.h"
#include "simulation/RunCase.h"

namespace squat::simulation {
results::RunResult runCase(const cases::CaseDescription&, const RunOptions&, Monitor&, results::RunResult*) {
  throw RunError("the rolling is not built yet", 0, 0, "");
}
}  // namespace squat::simulation
