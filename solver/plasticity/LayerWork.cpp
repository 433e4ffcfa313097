#include "plasticity/LayerWork.h"

#include <algorithm>
#include <cmath>

namespace squat::plasticity {

namespace {

// Displacements of a group's corners: 4 nodes x 3 components, each the 8 left stations and the right one of the last.
struct CornerLines {
  static constexpr int width = 16;
  alignas(64) double values[12 * width];

  CornerLines(const SurfaceLayer& layer, int along, std::size_t quad, const double* state) {
    const int station = layer.station(along);
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < 3; ++c) {
        double* line = values + (3 * i + c) * width;
        // Eight stations from a multiple of 8 on lie in one chunk of the state, the next may not.
        std::copy_n(state + layer.index(quad, i, c, station), lanes, line);
        line[lanes] = state[layer.index(quad, i, c, station + lanes)];
      }
  }
};

LayerCall callFor(const SurfaceLayer& layer, int along, std::size_t quad, const CornerLines* lines, LayerState& state,
                  LayerForces& forces) {
  const std::size_t g = layer.group(along, quad);
  const double twoMu = 2 * layer.law.shearModulus;
  LayerCall call;
  call.coefficients = layer.shapes[layer.shapeOf[g]].data();
  call.own = layer.own[g] != 0;
  for (int i = 0; lines && i < 4; ++i) call.corner[i] = lines->values + 3 * i * CornerLines::width;
  call.stride = CornerLines::width;
  call.state = state.values.data() + g * layer.groupState();
  call.force = forces.values.data() + g * groupForce;
  call.flowed = forces.flowed[g] != 0;
  call.radius = std::sqrt(2.0 / 3) * layer.law.yieldStress / twoMu;
  call.growth = std::sqrt(2.0 / 3) * layer.law.isotropic / twoMu;
  call.kinematicShare = 2.0 / 3 * layer.law.kinematic / twoMu;
  call.isotropicShare = 2.0 / 3 * layer.law.isotropic / twoMu;
  call.recovers = layer.law.recovers;
  for (int i = 0; i < backstressCount; ++i) {
    const auto& own = layer.law.backstresses[i];
    call.stiffness[i] = 2.0 / 3 * own.modulus / twoMu, call.recovery[i] = own.recovery;
    call.largest[i] = own.recovery > 0 ? std::sqrt(2.0 / 3) * own.modulus / own.recovery / twoMu : 0;
  }
  call.exponent = layer.law.exponent;
  call.saturation = std::sqrt(2.0 / 3) * layer.law.saturation / twoMu, call.rate = layer.law.rate;
  return call;
}

double coefficientOf(const SurfaceLayer& layer, std::size_t g, int i, int lane) {
  const auto& shape = layer.shapes[layer.shapeOf[g]];
  return layer.own[g] ? shape[static_cast<std::size_t>(i) * lanes + lane] : shape[i];
}

// Plastic strain rows of a point in one lane, and its weights in the work of 2 mu eps_p.
struct PointFlow {
  double e[5], m[5], equivalent;
};
const double* pointState(const SurfaceLayer& layer, const LayerState& state, std::size_t g, int p, int lane) {
  return state.values.data() + g * layer.groupState() + static_cast<std::size_t>(p) * layer.rows() * lanes + lane;
}
PointFlow pointFlow(const SurfaceLayer& layer, const LayerState& state, std::size_t g, int p, int lane) {
  const double* at = pointState(layer, state, g, p, lane);
  PointFlow f;
  for (int r = 0; r < 5; ++r) f.e[r] = at[r * lanes];
  f.equivalent = at[row::equivalent * lanes];
  f.m[0] = 2 * f.e[0] + f.e[1], f.m[1] = f.e[0] + 2 * f.e[1];
  for (int r = 2; r < 5; ++r) f.m[r] = 0.5 * f.e[r];
  return f;
}

// Per volume [J/m3]; `own` = eps_p:eps_p.
LayerEnergy pointEnergy(const SurfaceLayer& layer, const double* at, double equivalent, double own) {
  const auto& law = layer.law;
  if (!law.recovers)
    return {0, 0.5 * law.isotropic * equivalent * equivalent + law.kinematic * own / 3, law.yieldStress * equivalent};
  const double twoMu = 2 * law.shearModulus;
  double stored = 0;
  for (int i = 0; i < backstressCount; ++i) {
    if (law.backstresses[i].modulus <= 0) continue;
    const double* x = at + (row::backstress + 5 * i) * lanes;
    const double zz = x[0] + x[lanes];
    const double squared =
        x[0] * x[0] + x[lanes] * x[lanes] + zz * zz +
        0.5 * (x[2 * lanes] * x[2 * lanes] + x[3 * lanes] * x[3 * lanes] + x[4 * lanes] * x[4 * lanes]);
    stored += 0.75 * twoMu * twoMu * squared / law.backstresses[i].modulus;
  }
  return {0, stored, twoMu * at[row::work * lanes] - stored};
}

}  // namespace

LayerForces layerForces(const SurfaceLayer& layer, const LayerKernels& kernels, LayerState& state) {
  LayerForces forces;
  forces.values.assign(layer.size() * groupForce, 0.0);
  forces.flowed.assign(layer.size(), 0);
  for (int along = 0; along < layer.groups; ++along)
    for (std::size_t quad = 0; quad < layer.quads.size(); ++quad) {
      const std::size_t g = layer.group(along, quad);
      const double* values = state.values.data() + g * layer.groupState();
      if (std::all_of(values, values + layer.groupState(), [](double v) { return v == 0; })) continue;
      forces.flowed[g] = 1;
      kernels.plasticForce(callFor(layer, along, quad, nullptr, state, forces));
    }
  return forces;
}

void returnWindow(const SurfaceLayer& layer, const LayerKernels& kernels, const double* displaced, double x,
                  double reach, int part, int parts, LayerState& state, LayerForces& forces) {
  for (int along = 0; along < layer.groups; ++along) {
    if (layer.extent[along][1] < x - reach || layer.extent[along][0] > x + reach) continue;
    for (std::size_t quad = 0; quad < layer.quads.size(); ++quad) {
      const std::size_t g = layer.group(along, quad);
      if (static_cast<int>(g % parts) != part) continue;
      const CornerLines lines(layer, along, quad, displaced);
      if (kernels.returnToYield(callFor(layer, along, quad, &lines, state, forces))) forces.flowed[g] = 1;
    }
  }
}

void addPlasticForces(const SurfaceLayer& layer, const LayerForces& forces, int first, int end, double* lines,
                      const int* lineOfNode) {
  // The group before gives its right corners' force to the first station.
  const int from = std::max(0, (first - layer.firstInterval) / lanes - 1);
  for (int along = from; along < layer.groups && layer.station(along) < end; ++along) {
    const int station = layer.station(along);
    const int left = std::max(first - station, 0), right = std::min(lanes, end - station - 1);
    for (std::size_t quad = 0; quad < layer.quads.size(); ++quad) {
      const std::size_t g = layer.group(along, quad);
      if (!forces.flowed[g]) continue;
      const double* values = forces.values.data() + g * groupForce;
      for (int i = 0; i < 4; ++i)
        for (int c = 0; c < 3; ++c) {
          double* line =
              lines + (static_cast<std::size_t>(lineOfNode[layer.corners[quad][i]]) * 3 + c) * layer.stride + station;
          const double *onLeft = values + (3 * i + c) * lanes, *onRight = values + (12 + 3 * i + c) * lanes;
          for (int lane = left; lane < lanes; ++lane) line[lane] += onLeft[lane];
          for (int lane = std::max(left - 1, 0); lane < right; ++lane) line[lane + 1] += onRight[lane];
        }
    }
  }
}

ElementFlow elementFlow(const SurfaceLayer& layer, const LayerState& state, int sectionQuad, int interval) {
  ElementFlow mean;
  const int from = interval - layer.firstInterval;
  if (layer.empty() || state.values.empty() || layer.indexOfQuad[sectionQuad] < 0 || from < 0 ||
      from >= layer.groups * lanes)
    return mean;
  const std::size_t g = layer.group(from / lanes, static_cast<std::size_t>(layer.indexOfQuad[sectionQuad]));
  const int lane = from % lanes;
  for (int p = 0; p < points; ++p) {
    const auto f = pointFlow(layer, state, g, p, lane);
    const double whole[6] = {f.e[0], f.e[1], -f.e[0] - f.e[1], f.e[2], f.e[3], f.e[4]};
    for (int r = 0; r < 6; ++r) mean.strain[r] += whole[r] / points;
    mean.equivalent += f.equivalent / points;
  }
  return mean;
}

LayerEnergy layerEnergy(const SurfaceLayer& layer, const LayerState& state, const LayerForces& forces,
                        const double* u) {
  LayerEnergy energy;
  const double twoMu = 2 * layer.law.shearModulus;
  for (int along = 0; along < layer.groups; ++along)
    for (std::size_t quad = 0; quad < layer.quads.size(); ++quad) {
      const std::size_t g = layer.group(along, quad);
      if (!forces.flowed[g]) continue;
      for (int lane = 0; lane < lanes; ++lane) {
        const double* force = forces.values.data() + g * groupForce + lane;
        for (int i = 0; i < 4; ++i)
          for (int c = 0; c < 3; ++c) {
            const int station = layer.station(along) + lane;
            energy.elastic -= u[layer.index(quad, i, c, station)] * force[(3 * i + c) * lanes] +
                              u[layer.index(quad, i, c, station + 1)] * force[(12 + 3 * i + c) * lanes];
          }
        // 1/2 sum weight 2 mu eps_p:eps_p less what the incompatible modes give way, 1/2 f_a Kaa^-1 f_a: each
        // point's plastic strain works on the strain of the amplitudes that all of them make.
        double a[9] = {};
        for (int p = 0; p < points; ++p) {
          const auto f = pointFlow(layer, state, g, p, lane);
          for (int r = 0; r < 5; ++r)
            for (int i = 0; i < 9; ++i)
              a[i] += coefficientOf(layer, g, coefficient::amplitude + (p * 5 + r) * 9 + i, lane) * f.m[r];
        }
        for (int p = 0; p < points; ++p) {
          const auto f = pointFlow(layer, state, g, p, lane);
          const double weight = coefficientOf(layer, g, coefficient::weight + p, lane);
          double own = 0, given = 0;
          for (int r = 0; r < 5; ++r) {
            own += f.e[r] * f.m[r];
            for (int i = 0; i < 9; ++i)
              given += f.m[r] * a[i] * coefficientOf(layer, g, coefficient::inner + (p * 9 + i) * 5 + r, lane);
          }
          energy.elastic += 0.5 * weight * (own - given);
          const auto spent = pointEnergy(layer, pointState(layer, state, g, p, lane), f.equivalent, own);
          energy.hardening += weight / twoMu * spent.hardening;
          energy.dissipated += weight / twoMu * spent.dissipated;
        }
      }
    }
  return energy;
}

double largestEquivalentStrain(const SurfaceLayer& layer, const LayerState& state) {
  double maximum = 0;
  const std::size_t point = static_cast<std::size_t>(layer.rows()) * lanes;
  for (std::size_t at = row::equivalent * lanes; at < state.values.size(); at += point)
    for (int lane = 0; lane < lanes; ++lane) maximum = std::max(maximum, state.values[at + lane]);
  return maximum;
}

}  // namespace squat::plasticity
