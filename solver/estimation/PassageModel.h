// solver/estimation/PassageModel.h - the solver as a function: heights of a profile to axle box acceleration.
#pragma once

#include <memory>
#include <optional>

#include "case/CaseFile.h"
#include "core/Monitor.h"
#include "estimation/SmoothProfile.h"
#include "signals/TimeSeries.h"
#include "simulation/WarmState.h"

namespace squat::estimation {

// What a profile is looked for in: positions [m] in the frame of the search, whose zero is the location of the defect
// in the case.
struct SearchWindow {
  double first = 0, last = 0;  // of the profile
  double end = 0;              // of what is compared
};

// Low-passed acceleration [m/s2] of the axle box over position in the frame of the search: start and step in metres.
using PositionSeries = signals::TimeSeries;

// [m] between values over position: ten a period of the cut-off frequency [Hz].
double positionStep(double speed, double cutoff);

// The case with a mesh for any profile within the window, rolled no farther than needed.
cases::CaseDescription caseForSearch(const cases::CaseDescription& description, const SearchWindow& window,
                                     double speed, double cutoff);

// The case with a profile, its nodes not moved. The deepest point comes to stand at the location of the defect: the
// profile as a whole is shifted by some millimetres, which neither the track nor the mesh notices.
cases::CaseDescription withProfile(cases::CaseDescription description, const ProfilePoints& points);

// Runs at one speed, all from one warm state. May be called from several threads at once.
class PassageModel {
 public:
  PassageModel(cases::CaseDescription description, simulation::RunOptions options);

  // Equilibrium and run-up. False where it was cancelled.
  bool warmUp(int threads, Monitor& monitor);
  // Nothing where it was cancelled, or where this profile cannot be run.
  std::optional<PositionSeries> run(const ProfilePoints& points, Monitor& monitor) const;

 private:
  cases::CaseDescription description_;
  simulation::RunOptions options_;
  std::shared_ptr<const simulation::WarmState> warm_;
};

}  // namespace squat::estimation
