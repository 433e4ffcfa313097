// solver/simulation/WarmState.h - the state of a run just before its wheel can feel the defect. Runs whose cases differ
// in nothing but the defect start there: equilibrium and run-up are not computed again.
//
// What is in it: all that a checkpoint holds (displacements, velocities, friction, plastic strain, signals and energy
// from the start of rolling, pictures, the figures of mesh and equilibrium) and the case that it was made for.
//
// Why a run from it gives the same bits as the whole run. A profile enters as a term of the gap between wheel and rail,
// at the points of contact that it covers; mesh, stable step, equilibrium and masses see nothing of it once the fine
// zone of the mesh is set (mesh.zone_before, mesh.zone_behind). The state is taken while every point of the zone still
// has a gap, and a run refuses it where its own profile stands so high that the wheel would have touched it. Two things
// would reach farther: moved nodes (defect.move_nodes), whose elements waves feel ahead of the wheel, are refused; in a
// rail that yields the stretch in which contact is looked for is the one in which it may flow, and has to be the same.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "case/CaseDescription.h"
#include "core/Monitor.h"
#include "dynamics/Rolling.h"
#include "results/ArrayTree.h"
#include "simulation/RunCase.h"
#include "simulation/RunStart.h"

namespace squat::simulation {

struct WarmState {
  cases::CaseDescription description;  // it was made for; its zone keys are set
  double position = 0;                 // [m] of the wheel centre from the deepest point of the defect, negative
  results::ArrayTree state;            // as in a checkpoint
  std::string file;                    // it was read from, for messages; empty: none
  // On which it was made: runs need not build it again. None where the state was read from a file.
  std::shared_ptr<const model::Model> model;
};

// Rolls a case up to its defect; nothing where it was cancelled. Of the options threads and isa count, and whether
// modes and pictures are kept: without them a run from the state computes the former and lacks the latter's beginning.
// Throws CaseError for a case that cannot be run, whose nodes are moved, or whose run-up leaves no room; RunError.
std::optional<WarmState> makeWarmState(const cases::CaseDescription& description, const RunOptions& options,
                                       Monitor& monitor);

// The state rolled on until the wheel is about to feel a defect that begins `before` [m] ahead of its deepest point:
// it serves all defects that begin no earlier, of which `description` has one. Keeps the model. Nothing where it was
// cancelled. Throws as runCase from the state.
std::optional<WarmState> rollOn(const std::shared_ptr<const WarmState>& warm, const cases::CaseDescription& description,
                                double before, const RunOptions& options, Monitor& monitor);

// Throws CaseError with every key of which case and state differ, or where the state does not serve the defect.
void requireFit(const WarmState& warm, const cases::CaseDescription& description);

// Whether requireFit() is content.
bool fits(const WarmState& warm, const cases::CaseDescription& description);

// The case as a run from the state computes it: with the zone of the state's mesh, where its own would be another.
cases::CaseDescription onMeshOf(const WarmState& warm, cases::CaseDescription description);

// Throws CaseError (option --warm) where the wheel of a restored state touches the defect of the run's own case, or
// nearly: profiles that rise above the surface are felt earlier than others.
void requireAhead(const WarmState& warm, const dynamics::Rolling& rolling);

StoredState storedIn(const WarmState& warm);

std::size_t byteCount(const WarmState& warm);  // of the state; the model takes some times as much

}  // namespace squat::simulation
