// solver/simulation/SurfaceFields.h - the outer surface of the model and what is seen on it at an instant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/Rolling.h"
#include "results/RunResult.h"

namespace squat::simulation {

// Outer faces of all solids, and the inner faces on the plane y = 0 around the wheel's path.
class SurfaceFields {
 public:
  explicit SurfaceFields(const model::Model& model);

  const results::SurfaceMesh& mesh() const { return mesh_; }

  // Displacement (state layout, slaves and ghosts filled) with the wheel at `travel` and turned by `rotation`. Stress:
  // von Mises at element centres, averaged to nodes; only within 0.2 m of the contact, zero elsewhere, or all over.
  // Plastic strain: equivalent, mean of the integration points, averaged to nodes; empty where nothing may yield.
  results::SurfaceSnapshot snapshot(const std::string& name, const AlignedVector& u, double time, double travel,
                                    double rotation, const plasticity::LayerState& flow,
                                    bool stressEverywhere = false) const;

 private:
  enum class Part : std::uint8_t { rail, sleepers, rim, body, railCut, wheelCut };  // order of partNames
  struct Location {
    int block, node, station;
  };
  int point(int block, int node, int station);
  void addFace(Part part, const int (&points)[4]);
  void addBlock(int block, Part part, std::optional<Part> cutPart);
  void addSprings();
  void addPlasticStrain(const plasticity::LayerState& flow, results::SurfaceSnapshot& shot) const;

  const model::Model& model_;
  results::SurfaceMesh mesh_;
  std::vector<std::vector<int>> pointOf_;  // per block: nodes x (intervals + 1), -1 where not on the surface
  std::vector<Location> locations_;
};

}  // namespace squat::simulation
