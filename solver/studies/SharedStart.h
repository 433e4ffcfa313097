// solver/studies/SharedStart.h - runs of a study that vary only the defect start where the wheel begins to feel it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "case/CaseDescription.h"
#include "simulation/RunCase.h"
#include "simulation/WarmState.h"
#include "studies/CaseStudy.h"

namespace squat::studies {

// Where all points of a study share mesh, track, vehicle and motion, one warm state is made, by the run that comes
// first, and all runs start there. The fine zone of their mesh is then as long as the longest defect of the study,
// which is what each run computes by itself where all defects are equally long: the same table to the bit. Other
// studies, and defects whose nodes are moved, run whole.
class SharedStart {
 public:
  // `options` for each run; `threads` for the warm state, while the other runs wait for it.
  SharedStart(const StudyDefinition& definition, const cases::CaseOverrides& overrides, simulation::RunOptions options,
              int threads);

  bool isShared() const { return base_.has_value(); }

  // What decides the numbers of each run besides its case: the zone, in metres. Empty where runs are whole.
  std::string text() const;

  // simulation::runCase of one point of the study. May be called from several threads at once. Incomplete where it was
  // cancelled.
  results::RunResult run(const cases::CaseDescription& description, Monitor& monitor);

 private:
  struct Made {
    std::shared_ptr<const simulation::WarmState> state;  // none where none can be made
    bool cancelled = false;
  };
  Made stateFor(Monitor& monitor);

  simulation::RunOptions options_;
  int threads_;
  std::optional<cases::CaseDescription> base_;  // with the zone of all
  std::mutex mutex_;
  bool isMade_ = false;
  std::shared_ptr<const simulation::WarmState> state_;
};

}  // namespace squat::studies
