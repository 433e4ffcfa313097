// widgets/studio/preview/PreviewStart.h - the warm states that previews start from, kept from one to the next.
#pragma once

#include <memory>
#include <utility>

#include "studio/preview/Preview.h"

namespace squat::studio {

// Two of them: one before the finely meshed stretch, which serves every defect in it, and one that has been rolled on
// to where the wheel begins to feel the defect that is drawn now. A point that is dragged inside the defect leaves the
// latter as it is.
class PreviewStart {
 public:
  PreviewStart(const PreviewSolver& solver, simulation::RunOptions options)
      : solver_(solver), options_(std::move(options)) {}

  // The case that a preview of the open one runs, on the mesh of the states where that serves it.
  cases::CaseDescription caseOf(const cases::CaseDescription& open) const;
  // False where that case needs another mesh or another equilibrium.
  bool serves(const cases::CaseDescription& description) const;
  // Makes what is lacking. Null where it was cancelled. Throws CaseError, RunError.
  std::shared_ptr<const simulation::WarmState> stateFor(const cases::CaseDescription& description, Monitor& monitor);
  // The state that serves every defect on its mesh; null before one is made.
  const std::shared_ptr<const simulation::WarmState>& first() const { return first_; }
  void forget() { near_.reset(), first_.reset(); }

 private:
  bool isNearFor(double before) const;

  const PreviewSolver& solver_;
  simulation::RunOptions options_;
  std::shared_ptr<const simulation::WarmState> first_, near_;
  double nearBefore_ = 0;  // [m] the nearer state serves defects that begin at most so far before their deepest point
};

}  // namespace squat::studio
