#include "receptance/TrackImpulse.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/Errors.h"
#include "elasticity/SweptWork.h"
#include "model/BuildSupports.h"

namespace squat::receptance {

namespace {

struct Share {
  std::size_t index = 0;  // of the force buffer, or of the state
  double weight = 0;
};

// Place of a value between ascending positions: index of the left one and the fraction towards the right.
std::pair<int, double> place(const std::vector<double>& positions, double at) {
  int k = static_cast<int>(std::upper_bound(positions.begin(), positions.end(), at) - positions.begin()) - 1;
  k = std::clamp(k, 0, static_cast<int>(positions.size()) - 2);
  return {k, (at - positions[k]) / (positions[k + 1] - positions[k])};
}

constexpr int kVertical = 2;  // component of a block swept along x

// Even pressure over a square, taken at 8 x 8 points: how much of it each surface node carries.
std::vector<Share> loadShares(const model::Model& model, double position, double patch) {
  constexpr int points = 8;
  const auto& rail = model.blocks[model.rail];
  std::vector<Share> shares;
  for (int p = 0; p < points; ++p)
    for (int q = 0; q < points; ++q) {
      const auto [s, u] = place(rail.positions, position + ((p + 0.5) / points - 0.5) * patch);
      const auto [j, v] = place(model.surfaces.railY, ((q + 0.5) / points - 0.5) * patch);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          shares.push_back({model::forceSlot(model, rail.index(model.surfaces.railLine[j + a], kVertical, s + b)),
                            (a ? v : 1 - v) * (b ? u : 1 - u) / (points * points)});
    }
  return shares;
}

// Vertical mean over the section, each node by its mass.
std::vector<Share> sectionMean(const model::Model& model, double position) {
  const auto& rail = model.blocks[model.rail];
  const auto [s, u] = place(rail.positions, position);
  const auto& mass = model.mass[model.rail];
  std::vector<Share> shares;
  double sum = 0;
  for (int n = 0; n < rail.nodes; ++n) sum += mass[n * rail.stride + s];
  for (int n = 0; n < rail.nodes; ++n)
    for (int b = 0; b < 2; ++b)
      shares.push_back({rail.index(n, kVertical, s + b), mass[n * rail.stride + s] / sum * (b ? u : 1 - u)});
  return shares;
}

std::vector<int> trackBlocks(const model::Model& model) {
  std::vector<int> track{model.rail};
  for (int i = 0; i < model.sleepers; ++i) track.push_back(model.firstSleeper + i);
  return track;
}

class Track {
 public:
  Track(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, const ImpulseOptions& o)
      : model_(model),
        kernels_(kernels),
        team_(team),
        options_(o),
        work_(elasticity::partition(model.blocks, trackBlocks(model), team.size())),
        now_(model.stateSize, 0.0),
        next_(model.stateSize, 0.0),
        velocity_(model.stateSize, 0.0),
        forces_(model.forceSize, 0.0) {
    for (int i = 0; i < team.size(); ++i) scratch_.push_back(std::make_unique<elasticity::KernelScratch>(model.blocks));
    for (const auto& block : model.blocks) acceleration_.emplace_back(3 * block.stride, 0.0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      elasticity::BlockStep with;
      inverseMass_.push_back(elasticity::inChunks(model.blocks[b], model.inverseMass[b].data()));
      with.inverseMass = inverseMass_.back().data();
      with.freeMask = model.freeMask[b].data();
      with.lineOfNode = model.loaded[b].lineOfNode.data();
      with.slave = model.slave[b].data();
      with.force = forces_.data() + model.loaded[b].offset;
      with.acceleration = acceleration_[b].data();
      with.beta = o.beta;
      steps_.push_back(with);
    }
  }

  // before(u, v): called with the state before each step; adds the load to `forces`.
  template <typename Before>
  void advance(long count, const Before& before) {
    team_.run([&](int index) {
      for (long k = 0; k < count; ++k) {
        double* u = k % 2 ? next_.data() : now_.data();
        double* target = k % 2 ? now_.data() : next_.data();
        if (index == 0) {
          for (const auto held : model_.held) u[held] = 0, velocity_[held] = 0;
          before(u, velocity_.data(), forces_.data());
          addSpringForces(model_.ballast, u, velocity_.data(), forces_.data());
          addSpringForces(model_.pads, u, velocity_.data(), forces_.data());
          addSpringForces(model_.ends, u, velocity_.data(), forces_.data());
        }
        team_.barrier();
        elasticity::advanceSegments(work_[index], model_.blocks, kernels_, steps_, options_.step, u, target,
                                    velocity_.data(), *scratch_[index]);
        team_.barrier();
      }
    });
    if (count % 2) now_.swap(next_);
  }

 private:
  const model::Model& model_;
  const elasticity::KernelSet& kernels_;
  ThreadTeam& team_;
  const ImpulseOptions& options_;
  std::vector<std::vector<elasticity::Segment>> work_;
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch_;
  std::vector<elasticity::BlockStep> steps_;
  std::vector<AlignedVector> inverseMass_;
  std::vector<AlignedVector> acceleration_;  // none: weight leaves small vibrations as they are
  AlignedVector now_, next_, velocity_, forces_;
};

double largestIn(const std::vector<double>& values, std::size_t first) {
  double largest = 0;
  for (std::size_t i = first; i < values.size(); ++i) largest = std::max(largest, std::abs(values[i]));
  return largest;
}

}  // namespace

ImpulseRecord strikeTrack(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                          double position, const ImpulseOptions& options, Monitor& monitor) {
  const auto load = loadShares(model, position, options.patch);
  const auto mean = sectionMean(model, position);
  const long every = std::max(1L, std::lround(options.sampling / options.step));
  const long steps = every * static_cast<long>(std::ceil(options.duration / options.step / static_cast<double>(every)));
  Track track(model, kernels, team, options);
  ImpulseRecord record;
  record.forceStep = options.step;
  record.sampleStep = options.step * static_cast<double>(every);
  long step = 0;
  const auto before = [&](const double* u, const double* v, double* forces) {
    const double time = static_cast<double>(step) * options.step;
    if (time < options.pulse) {
      const double force = std::pow(std::sin(std::numbers::pi * time / options.pulse), 2);
      for (const auto& share : load) forces[share.index] -= share.weight * force;
      record.force.push_back(force);
    }
    if (step % every == 0) {
      double sum = 0;
      for (const auto& share : mean) sum -= share.weight * (u[share.index] - options.beta * v[share.index]);
      record.response.push_back(sum);
    }
    ++step;
  };
  const long slice = 100 * every;
  double reported = 0;
  while (step < steps) {
    if (monitor.cancelled()) {
      record.cancelled = true;
      return record;
    }
    track.advance(std::min(slice, steps - step), before);
    if (!std::isfinite(record.response.back()) || std::abs(record.response.back()) > 1)
      throw RunError(
          "the struck track diverges: the time step of " + std::to_string(1e6 * options.step) + " us is too long", step,
          static_cast<double>(step) * options.step, "rail, struck section");
    record.left = largestIn(record.response, record.response.size() * 9 / 10) / largestIn(record.response, 0);
    const double done = static_cast<double>(step) / static_cast<double>(steps);
    if (done - reported >= 0.05 || step >= steps) {
      Progress progress;
      progress.phase = "struck track";
      progress.fraction = reported = done;
      progress.simulatedTime = static_cast<double>(step) * options.step;
      monitor.report(progress);
    }
    if (record.left<options.enough&& static_cast<double>(step) * options.step> options.shortest) break;
  }
  return record;
}

}  // namespace squat::receptance
