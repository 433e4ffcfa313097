// solver/model/BuildBlocks.h - the solids of the track and the half wheelset as swept blocks.
#pragma once

#include "model/Model.h"

namespace squat::model {

// Where the wheel rolls and where the sections stand.
struct RollingStretch {
  double from = 0, to = 0;  // [m] rail positions that are meshed for rolling
  geometry::Stations rail;
  std::vector<geometry::StationRun> rolled;  // the runs between from and to
};
RollingStretch rollingStretch(const scenario::Scenario& scenario, double railStart, double railEnd);

// Adds rail, rim, wheel body and sleepers to the model, prepared, with offsets in the state.
// Returns the stretch that can be rolled over. Throws CaseError where the case cannot be meshed.
RollingStretch addBlocks(Model& model, int sleeperIntervals = 0);

// The rail of a case without stations; sleepers at model.sleeperPositions, `intervals` along a half sleeper (0: as the
// mesh preset has it); a block at the end of the state, prepared.
elasticity::SweptBlock railBlock(const scenario::Scenario& scenario);
void addSleepers(Model& model, int intervals);
void append(Model& model, elasticity::SweptBlock block);

}  // namespace squat::model
