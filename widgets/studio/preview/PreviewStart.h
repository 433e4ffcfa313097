// widgets/studio/preview/PreviewStart.h - the warm states that previews start from, kept from one to the next.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "studio/preview/Preview.h"

namespace squat::studio {

// For each of the last few meshes there are two: one before the finely meshed stretch, which serves every defect in it,
// and one that has been rolled on to where the wheel begins to feel the defect that is drawn now. A point that is
// dragged inside the defect leaves the latter as it is, and a slider that is pulled back and forth finds its meshes
// again.
class PreviewStart {
 public:
  PreviewStart(const PreviewSolver& solver, simulation::RunOptions options)
      : solver_(solver), options_(std::move(options)) {}

  using State = std::shared_ptr<const simulation::WarmState>;

  // False where the case needs another mesh or another equilibrium than those that are kept.
  bool serves(const cases::CaseDescription& description) const;
  // Makes what is lacking. Null where it was cancelled. Throws CaseError, RunError.
  State stateFor(const cases::CaseDescription& description, Monitor& monitor);
  // On the mesh of the last stateFor(): the state that serves every defect on it; null before one is made.
  State first() const { return meshes_.empty() ? nullptr : meshes_.front().first; }

 private:
  struct OfOneMesh {
    State first, near;
    double nearBefore = 0;  // [m] the nearer state serves defects that begin at most so far before their deepest point
  };
  // The states of the case's mesh. False where they are not kept.
  bool bringToFront(const cases::CaseDescription& description);
  State rolledOn(OfOneMesh& mesh, const cases::CaseDescription& description, Monitor& monitor);

  const PreviewSolver& solver_;
  simulation::RunOptions options_;
  std::vector<OfOneMesh> meshes_;  // the latest first
};

// Whether the state was made on the very mesh that the case asks for. A longer mesh would serve the case too, but with
// other numbers: a preview is to show the same for the same case.
bool isOnMeshOf(const simulation::WarmState& state, const cases::CaseDescription& description);

}  // namespace squat::studio
