#include "simulation/ModelFields.h"

#include <algorithm>

namespace squat::simulation {

namespace {

void appendTo(std::vector<float>& all, const std::vector<float>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// Triples of x, y and z.
std::vector<float> mirroredAt(std::vector<float> values, double plane) {
  for (std::size_t i = 1; i < values.size(); i += 3) values[i] = static_cast<float>(2 * plane) - values[i];
  return values;
}

void appendMirrored(results::SurfaceMesh& mesh, const results::SurfaceMesh& right, double plane) {
  const auto first = static_cast<std::int32_t>(mesh.points.size() / 3);
  appendTo(mesh.points, mirroredAt(right.points, plane));
  appendTo(mesh.springs, mirroredAt(right.springs, plane));
  for (std::size_t quad = 0; quad < right.part.size(); ++quad) {
    if (right.partNames[right.part[quad]].ends_with(" cut")) continue;
    mesh.part.push_back(right.part[quad]);
    for (std::size_t corner = 4; corner-- > 0;) mesh.quads.push_back(first + right.quads[4 * quad + corner]);
  }
}

}  // namespace

ModelFields::ModelFields(const model::Model& left, const model::Model* right) {
  sides_.emplace_back(left);
  mesh_ = sides_.front().mesh();
  if (!right) return;
  sides_.emplace_back(*right);
  appendMirrored(mesh_, sides_.back().mesh(), -left.scenario.wheelset.trackCentre);
}

results::SurfaceSnapshot ModelFields::snapshot(const std::string& name, const std::vector<State>& sides, double time,
                                               double travel, double rotation, bool stressEverywhere) const {
  const auto of = [&](std::size_t side) {
    return sides_[side].snapshot(name, sides[side].displacement, time, travel, rotation, sides[side].flow,
                                 stressEverywhere);
  };
  auto shot = of(0);
  if (sides_.size() == 1) return shot;
  const auto right = of(1);
  appendTo(shot.displacement, mirroredAt(right.displacement, 0));
  appendTo(shot.vonMises, right.vonMises);
  appendTo(shot.plasticStrain, right.plasticStrain);
  return shot;
}

results::SurfaceSnapshot ModelFields::snapshot(const std::string& name, const dynamics::Rolling& rolling) const {
  std::deque<AlignedVector> displacements;
  std::vector<State> states;
  for (const auto* side : rolling.sides())
    states.push_back({displacements.emplace_back(side->displacement()), side->state().plastic});
  return snapshot(name, states, rolling.state().time, rolling.view().position - rolling.model().startX,
                  rolling.state().rotation);
}

}  // namespace squat::simulation
