// solver/simulation/ModelFields.h - what is seen of a half or a whole model, as one surface.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "simulation/SurfaceFields.h"

namespace squat::simulation {

// The surface of the left side, or of the half model; of a whole model that of the right side too, as its mirror image
// at the track centre, in the same parts. The inner faces on the plane of the rail's axis are those of the left side
// alone.
class ModelFields {
 public:
  // `right`: null for a half model.
  ModelFields(const model::Model& left, const model::Model* right);

  const results::SurfaceMesh& mesh() const { return mesh_; }

  struct State {
    const AlignedVector& displacement;
    const plasticity::LayerState& flow;
  };
  // As SurfaceFields::snapshot(), with the state of each side: the left one first.
  results::SurfaceSnapshot snapshot(const std::string& name, const std::vector<State>& sides, double time,
                                    double travel, double rotation, bool stressEverywhere = false) const;
  // Of a rolling model, at its present step.
  results::SurfaceSnapshot snapshot(const std::string& name, const dynamics::Rolling& rolling) const;

 private:
  std::deque<SurfaceFields> sides_;
  results::SurfaceMesh mesh_;
};

}  // namespace squat::simulation
