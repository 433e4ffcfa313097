#include "model/WheelMotion.h"

#include <cmath>

#include "core/ElementaryFunctions.h"
#include "elasticity/SweptWork.h"

namespace squat::model {

void turnStations(const elasticity::SweptBlock& body, double rotation, TurnedStations& turned) {
  turned.sine.resize(body.stationCount), turned.cosine.resize(body.stationCount);
  for (int s = 0; s < body.stationCount; ++s) {
    turned.sine[s] = elementary::sin(body.positions[s] - rotation);
    turned.cosine[s] = elementary::cos(body.positions[s] - rotation);
  }
}

PlaneVector ringMean(const Model& model, const Ring& ring, const TurnedStations& turned, const double* state) {
  const auto& block = model.blocks[ring.block];
  PlaneVector mean;
  for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
    const auto a = block.line(state, ring.nodes[i], 0), b = block.line(state, ring.nodes[i], 1);
    double x = 0, z = 0;
    for (int s = 0; s < block.stationCount; ++s) {
      x += turned.cosine[s] * a[s] + turned.sine[s] * b[s];
      z += turned.sine[s] * a[s] - turned.cosine[s] * b[s];
    }
    mean.x += ring.weight[i] * x / block.stationCount;
    mean.z += ring.weight[i] * z / block.stationCount;
  }
  return mean;
}

void followJournal(const Model& model, const TurnedStations& turned, double* state) {
  const auto mean = ringMean(model, model.bearing, turned, state);
  state[model.journalX] = mean.x, state[model.journalZ] = mean.z;
}

void addRingForce(const Model& model, const Ring& ring, const TurnedStations& turned, PlaneVector force,
                  double* forces) {
  const auto& block = model.blocks[ring.block];
  const auto& loaded = model.loaded[ring.block];
  for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
    double* a = forces + loaded.offset + static_cast<std::size_t>(loaded.lineOfNode[ring.nodes[i]]) * 3 * block.stride;
    double* b = a + block.stride;
    const double fx = force.x * ring.weight[i] / block.stationCount, fz = force.z * ring.weight[i] / block.stationCount;
    for (int s = 0; s < block.stationCount; ++s) {
      a[s] += turned.cosine[s] * fx + turned.sine[s] * fz;
      b[s] += turned.sine[s] * fx - turned.cosine[s] * fz;
    }
  }
}

std::vector<std::pair<std::size_t, double>> ringTerms(const Model& model, const Ring& ring,
                                                      const TurnedStations& turned, PlaneVector direction) {
  const auto& block = model.blocks[ring.block];
  std::vector<std::pair<std::size_t, double>> terms;
  for (std::size_t i = 0; i < ring.nodes.size(); ++i)
    for (int s = 0; s < block.stationCount; ++s) {
      const double share = ring.weight[i] / block.stationCount;
      terms.push_back(
          {block.index(ring.nodes[i], 0, s), share * (turned.cosine[s] * direction.x + turned.sine[s] * direction.z)});
      terms.push_back(
          {block.index(ring.nodes[i], 1, s), share * (turned.sine[s] * direction.x - turned.cosine[s] * direction.z)});
    }
  return terms;
}

double ringLateralMean(const Model& model, const Ring& ring, const double* state) {
  const auto& block = model.blocks[ring.block];
  double mean = 0;
  for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
    const auto c = block.line(state, ring.nodes[i], 2);
    double sum = 0;
    for (int s = 0; s < block.stationCount; ++s) sum += c[s];
    mean += ring.weight[i] * sum / block.stationCount;
  }
  return mean;
}

void addRingLateralForce(const Model& model, const Ring& ring, double force, double* forces) {
  const auto& block = model.blocks[ring.block];
  const auto& loaded = model.loaded[ring.block];
  for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
    double* c =
        forces + loaded.offset + (static_cast<std::size_t>(loaded.lineOfNode[ring.nodes[i]]) * 3 + 2) * block.stride;
    const double share = force * ring.weight[i] / block.stationCount;
    for (int s = 0; s < block.stationCount; ++s) c[s] += share;
  }
}

std::vector<std::pair<std::size_t, double>> ringLateral(const Model& model, const Ring& ring) {
  const auto& block = model.blocks[ring.block];
  std::vector<std::pair<std::size_t, double>> terms;
  for (std::size_t i = 0; i < ring.nodes.size(); ++i)
    for (int s = 0; s < block.stationCount; ++s)
      terms.push_back({block.index(ring.nodes[i], 2, s), ring.weight[i] / block.stationCount});
  return terms;
}

void turnBases(const Model& model, double rotation, AlignedVector& state) {
  const double c = elementary::cos(rotation), s = elementary::sin(rotation);
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n) {
      const auto along = block.line(state.data(), n, 0), radial = block.line(state.data(), n, 1);
      for (int k = 0; k < block.stationCount; ++k) {
        const double a = along[k], r = radial[k];
        along[k] = c * a + s * r;
        radial[k] = c * r - s * a;
      }
    }
  }
  elasticity::refreshGhosts(model.blocks, state.data());
}

double meanRotation(const Model& model, const double* state) {
  double sum = 0;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n) {
      double line = 0;
      for (int s = 0; s < block.stationCount; ++s)
        line += model.mass[b][n * block.stride + s] * state[block.index(n, 0, s)];
      sum += line * block.section.nodes[n][0];
    }
  }
  return sum / model.wheelset.inertia;
}

void removeMeanRotation(const Model& model, double rotation, double* state) {
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s) state[block.index(n, 0, s)] -= rotation * block.section.nodes[n][0];
  }
  elasticity::refreshGhosts(model.blocks, state);
}

}  // namespace squat::model
