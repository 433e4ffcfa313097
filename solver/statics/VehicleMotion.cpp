#include "statics/VehicleMotion.h"

#include <Eigen/Core>
#include <cmath>

#include "core/ElementaryFunctions.h"

namespace squat::statics {

void addVerticalMotion(const model::Model& model, double rotation, double upwards, double* state) {
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int s = 0; s < block.stationCount; ++s) {
      const Eigen::Vector3d local =
          elasticity::localBasis(block, block.positions[s] - rotation).transpose() * Eigen::Vector3d(0, 0, upwards);
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 2; ++c) state[block.index(n, c, s)] += local[c];
    }
  }
  state[model.sprungZ] += upwards;
  if (model.boxOnSpring()) state[model.boxZ] += upwards;
}

void addRoll(const model::Model& model, double rotation, double wheelUpwards, double* state) {
  const auto& w = model.scenario.wheelset;
  const double angle = wheelUpwards / w.trackCentre;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int s = 0; s < block.stationCount; ++s) {
      const Eigen::Matrix3d basis = elasticity::localBasis(block, block.positions[s] - rotation);
      for (int n = 0; n < block.nodes; ++n) {
        const auto& p = block.section.nodes[n];  // radius, outwards from the wheel plane
        const double height = (basis * Eigen::Vector3d(0, p[0], 0)).z();
        const Eigen::Vector3d local =
            basis.transpose() * Eigen::Vector3d(0, -angle * height, angle * (p[1] + w.trackCentre));
        for (int c = 0; c < 3; ++c) state[block.index(n, c, s)] += local[c];
      }
    }
  }
  const double atBearing = angle * (w.bearingCentre + w.trackCentre);
  state[model.sprungZ] += atBearing;
  if (model.boxOnSpring()) state[model.boxZ] += atBearing;
}

double verticalOfRailSection(const model::Model& model, const AlignedVector& state, int station) {
  const auto& rail = model.blocks[model.rail];
  const double sine = elementary::sin(rail.lean), cosine = elementary::cos(rail.lean);
  double sum = 0, mass = 0;
  for (int n = 0; n < rail.nodes; ++n) {
    const double m = model.mass[model.rail][n * rail.stride + station];
    sum += m * (sine * state[rail.index(n, 1, station)] + cosine * state[rail.index(n, 2, station)]), mass += m;
  }
  return sum / mass;
}

}  // namespace squat::statics
