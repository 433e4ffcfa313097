// solver/simulation/Describe.h - figures of mesh, equilibrium, modes and profile as they stand in a result, and
// spectra.
#pragma once

#include <string>
#include <vector>

#include "dynamics/Rolling.h"
#include "dynamics/StableStep.h"
#include "results/RunResult.h"
#include "statics/Equilibrium.h"

namespace squat::simulation {

void describeEquilibrium(const model::Model& model, const statics::Equilibrium& equilibrium,
                         results::RunResult& result);
// Of a whole model, behind those of the left side: what the right side has of its own.
void describeRightEquilibrium(const model::Model& right, const statics::Equilibrium& equilibrium,
                              results::RunResult& result);
void describeMesh(const model::Model& model, const dynamics::StableStep& stable, double step,
                  results::RunResult& result);
std::vector<results::WheelsetMode> naturalModes(const scenario::Scenario& scenario);
void describeProfile(const scenario::Scenario& scenario, results::RunResult& result);

// What plastic flow leaves behind: fields of the unloaded rail and their largest values. `unloaded`: state layout.
void describePermanentChange(const dynamics::Rolling& rolling, const AlignedVector& unloaded,
                             results::RunResult& result);

// PSD and scalogram of what has been recorded. Returns why there are none, or what to mind in them; else an empty text.
std::string addSpectra(const scenario::Scenario& scenario, results::RunResult& result);

}  // namespace squat::simulation
