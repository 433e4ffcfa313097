// solver/growth/PassingWheelset.h - one wheelset of the traffic, which rolls over the changing rail again and again.
//
// It stands released just before the zone, as a warm state does: mesh, equilibrium and run-up are computed once. The
// rail is linear but for contact and the layer that yields, and both are out of reach of the wheel there: so what
// plastic strain has left behind is added to the displacements of that state, and the passage begins as if the wheel
// had rolled up to the changed rail.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Monitor.h"
#include "growth/RailSurface.h"
#include "plasticity/LayerWork.h"
#include "simulation/OpenRun.h"

namespace squat::growth {

// What one passage did and showed.
struct Passage {
  plasticity::LayerState layer;                // afterwards
  std::vector<double> worn;                    // [m] at the contact points
  double frictionWork = 0;                     // [J] in the whole passage
  double smallestForce = 0, largestForce = 0;  // [N] vertical, in the zone
  std::vector<double> position, acceleration;  // [m], [m/s2] axle box, low-passed at output.filter_cutoff
};

// What it rolls over.
struct ChangedRail {
  const plasticity::LayerState& layer;
  const AlignedVector& displacement;  // that the plastic strain leaves behind, in the state layout of `model`
  const model::Model& model;
  const Field& shape;  // [m] that the wheel is to meet
  const Field& risen;  // [m] by which the displacement moves the surface
};

class PassingWheelset {
 public:
  // Throws CaseError.
  PassingWheelset(cases::CaseDescription description, int threads, const std::string& isa, Monitor& monitor);
  PassingWheelset(const PassingWheelset&) = delete;
  PassingWheelset& operator=(const PassingWheelset&) = delete;

  // Mesh, equilibrium and run-up. False where it was cancelled. Throws CaseError where the run-up leaves no room.
  bool release();
  // Nothing where it was cancelled. Throws RunError where the wheel leaves the rail for good.
  std::optional<Passage> roll(const SurfaceGrid& grid, const ChangedRail& rail);

  const model::Model& model() const { return run_.model; }
  const cases::CaseDescription& description() const { return description_; }
  const elasticity::KernelSet& kernels() const { return run_.kernels; }
  ThreadTeam& team() const { return *run_.team; }
  double speed() const { return description_.motion.speed; }
  const std::vector<std::string>& warnings() const { return run_.result.warnings; }

 private:
  dynamics::RollingState startOn(const ChangedRail& rail) const;

  cases::CaseDescription description_;
  simulation::RunOptions options_;
  simulation::OpenRun run_;
  dynamics::RollingState released_;
  BareSurface bare_;
};

}  // namespace squat::growth
