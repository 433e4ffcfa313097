// widgets/studio/preview/Preview.h - what is shown of a preview, and who computes it. Plain values.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/WarmState.h"
#include "studio/runs/RunController.h"

namespace squat::studio {

// The solver as a preview uses it: simulation::makeWarmState, rollOn and runCase in the program, made-up ones in tests.
struct PreviewSolver {
  std::function<std::optional<simulation::WarmState>(const cases::CaseDescription&, const simulation::RunOptions&,
                                                     Monitor&)>
      makeStart;
  std::function<std::optional<simulation::WarmState>(const std::shared_ptr<const simulation::WarmState>&,
                                                     const cases::CaseDescription&, double before,
                                                     const simulation::RunOptions&, Monitor&)>
      rollOn;
  Runner run;
  bool isThere() const { return makeStart && rollOn && run; }
};

enum class PreviewPhase {
  waiting,      // nothing is asked for
  preparing,    // the state that previews start from is made: what was shown is out of date
  rolling,      // the curve grows
  done,         // `result` is there
  unavailable,  // this case has no preview: `text` says why
};

struct Preview {
  PreviewPhase phase = PreviewPhase::waiting;
  std::string text;                                       // preparing: what is done; unavailable: why, a sentence
  double fraction = 0;                                    // preparing: 0..1
  double from = 0, to = 0, defectFrom = 0, defectTo = 0;  // [m] of the wheel's way, and of the defect
  // So far, from the start of rolling: wheel position [m], low-passed axle box acceleration [m/s2].
  std::vector<double> position, acceleration;
  ResultPointer result;  // done: all of it
};

}  // namespace squat::studio
