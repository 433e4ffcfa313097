#include "verification/RollingBlocks.h"

#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/Resolve.h"
#include "elasticity/SweptSamples.h"
#include "geometry/RailSection.h"

namespace squat::contact {

namespace {

using elasticity::steel;

constexpr double damping = 1e5;             // [1/s] of velocities: about critical for the blocks' lowest modes
constexpr double sinkingTime = 30e-6;       // [s] in which the load is found, after the waves have gone
constexpr double highFrequencyShare = 0.1;  // of critical, stiffness-proportional, as the program has it

// From 0 to `even` in equal steps, then growing to at least `to`.
std::vector<double> graded(double size, double even, double to, double growth) {
  std::vector<double> at{0};
  while (at.back() < even - 1e-9) at.push_back(at.back() + size);
  for (double step = size * growth; at.back() < to; step *= growth) at.push_back(at.back() + step);
  return at;
}

geometry::Stations stations(const RolledCase& with) {
  const int half = static_cast<int>(std::ceil(1.6 * with.halfAxis / with.size / 4)) * 4;
  const double coarse = std::ceil((with.extent * with.halfAxis / with.size - half) / 8) * with.size;
  return {-half * with.size - 8 * coarse, false, {{8, coarse}, {2 * half, with.size}, {8, coarse}}};
}

}  // namespace

RollingBlocks::RollingBlocks(const RolledCase& with) : with_(with) {
  build();
  const double normal = with.normalPenalty * steel.young / with.size;
  law_ = {normal, with.tangentialShare * normal, with.friction};
  step_ = stableStep();
  scratch_ = std::make_unique<elasticity::KernelScratch>(blocks_);
  massChunks_.reserve(blocks_.size());
  const double beta = highFrequencyShare * step_;  // 2 zeta / omega at omega = 2 / step
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    elasticity::BlockStep own;
    massChunks_.push_back(elasticity::inChunks(blocks_[b], inverseMass_[b].data()));
    own.inverseMass = massChunks_.back().data(), own.freeMask = freeMask_[b].data();
    own.lineOfNode = lineOfNode_[b].data(), own.slave = slave_[b].data(), own.force = forces_[b].data();
    own.acceleration = acceleration_[b].data(), own.beta = beta;
    blockSteps_.push_back(own);
  }
}

void RollingBlocks::build() {
  const double reach = with_.extent * with_.halfAxis;
  // Half of the patch by symmetry; in plane strain one column.
  const auto y = with_.plane ? std::vector<double>{-with_.size / 2, with_.size / 2}
                             : graded(with_.size, with_.halfAxis, reach, 1.45);
  const auto depth = graded(with_.size, 0.8 * with_.halfAxis, reach, 1.45);
  width_ = with_.plane ? 1 : 2;
  elasticity::SweptBlock rail, wheel;
  rail.name = "rail", wheel.name = "wheel", rail.material = wheel.material = steel;
  rail.stations = stations(with_);
  const std::vector<double> up(depth.rbegin(), depth.rend());
  rail.section = elasticity::gridSection(y, up);
  for (auto& node : rail.section.nodes)
    node[1] = -node[1] + geometry::crownHeight(geometry::RailSection::rail54E1, std::min(std::abs(node[0]), 0.0244));
  wheel.kind = elasticity::SweepKind::aroundAxis;
  wheel.section = elasticity::gridSection(up, y);
  for (auto& node : wheel.section.nodes) node[0] = with_.radius - node[0];
  wheel.stations = rail.stations;
  wheel.stations.start = rail.stations.start / with_.radius;
  for (auto& run : wheel.stations.runs) run.length /= with_.radius;
  blocks_ = {rail, wheel};
  const std::size_t size = elasticity::layOut(blocks_);
  displaced_.assign(size, 0.0), target_ = velocity_ = displaced_;

  auto description = cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}});
  description.wheelset.radius = with_.radius;
  const auto& at = blocks_[0].positions;
  surfaces_ = makeSurfaces(blocks_[0], 0, blocks_[1], 1, description, at[8] + 1e-9, at[at.size() - 9] - 1e-9);
  surfaces_.rolledInterval = 0;

  for (int b = 0; b < 2; ++b) {
    const auto& block = blocks_[b];
    const auto mass = elasticity::lumpedMass(block);
    AlignedVector inverse(mass.size(), 0.0);
    std::vector<double> mask(block.lines(), 1.0);
    for (int n = 0; n < block.nodes; ++n) {
      // The end stations belong to the far faces.
      for (int s = 1; s < block.intervals; ++s) inverse[n * block.stride + s] = 1 / mass[n * block.stride + s];
      const double across = block.section.nodes[n][b];
      const bool far = b == 0 ? n < static_cast<int>(y.size()) : n % static_cast<int>(depth.size()) == 0;
      const int lateral = b == 0 ? 1 : 2;
      if (far || (!with_.plane && across > y.back() - 1e-9)) mask[3 * n] = mask[3 * n + 1] = mask[3 * n + 2] = 0;
      if (with_.plane || across < 1e-9) mask[3 * n + lateral] = 0;
    }
    inverseMass_.push_back(std::move(inverse)), freeMask_.push_back(std::move(mask));
    acceleration_.emplace_back(3 * block.stride, 0.0);
    slave_.emplace_back(block.nodes, 0);
    const auto& line = b == 0 ? surfaces_.railLine : surfaces_.treadLine;
    lineOfNode_.emplace_back(block.nodes, -1);
    for (std::size_t i = 0; i < line.size(); ++i) lineOfNode_[b][line[i]] = static_cast<int>(i);
    forces_.emplace_back(line.size() * 3 * block.stride, 0.0);
  }
}

// From the highest eigenvalue of the bare blocks by power steps, and what the penalty adds at a node of the surface
// that all points around it push: a bound of the sum.
double RollingBlocks::stableStep() {
  AlignedVector u(displaced_.size(), 0.0);
  unsigned seed = 1;
  for (double& v : u) seed = seed * 1664525u + 1013904223u, v = static_cast<double>(seed >> 8) / (1u << 24) - 0.5;
  double value = 0;
  for (int k = 0; k < 60; ++k) {
    double before = 0, after = 0;
    AlignedVector force = elasticity::applySwept(blocks_, u, "");
    for (int b = 0; b < 2; ++b)
      for (int n = 0; n < blocks_[b].nodes; ++n)
        for (int c = 0; c < 3; ++c)
          for (int s = 0; s < blocks_[b].stationCount; ++s) {
            const std::size_t i = blocks_[b].index(n, c, s);
            force[i] *= inverseMass_[b][n * blocks_[b].stride + s] * freeMask_[b][3 * n + c];
          }
    for (std::size_t i = 0; i < u.size(); ++i) before += u[i] * u[i], after += force[i] * force[i];
    value = std::sqrt(after / before);
    const double scale = 1 / std::sqrt(after);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = scale * force[i];
  }
  // Two nodes with half an element's mass each against the penalty of an element's face.
  const double mass = steel.density * with_.size / 2;  // [kg/m2]
  const double pushed = 2 * std::max(law_.normalPenalty, law_.tangentialPenalty) / mass;
  return 0.9 * 0.905 * 2 / std::sqrt(1.05 * value + pushed);
}

std::size_t RollingBlocks::elements() const { return blocks_[0].elements() + blocks_[1].elements(); }

void RollingBlocks::step(double speed, double angularVelocity, PatchState& patch, std::vector<PatchPoint>* points) {
  static const auto kernels = elasticity::kernelsFor("");
  const double beta = blockSteps_[0].beta;
  const WheelRolling wheel{placement_, speed, angularVelocity};
  patch =
      rollContact({surfaces_, blocks_[0], blocks_[1], law_}, {wheel, displaced_.data(), velocity_.data(), step_},
                  history_, {{forces_[0].data(), lineOfNode_[0].data()}, {forces_[1].data(), lineOfNode_[1].data()}},
                  {nullptr, points, nullptr});
  blockSteps_[1].cosine = std::cos(angularVelocity * step_), blockSteps_[1].sine = std::sin(angularVelocity * step_);
  std::vector<elasticity::Segment> all{{0, 0, blocks_[0].intervals}, {1, 0, blocks_[1].intervals}};
  for (auto& with : blockSteps_) with.kernels = &kernels;
  elasticity::advanceSegments(all, blocks_, blockSteps_, step_, displaced_.data(), target_.data(), velocity_.data(),
                              *scratch_);
  displaced_.swap(target_);
  const double lost = damping * step_;
  for (std::size_t i = 0; i < velocity_.size(); ++i)
    displaced_[i] -= beta * lost * velocity_[i], velocity_[i] *= 1 - lost;
  placement_.centreX += speed * step_, placement_.rotation += angularVelocity * step_;
  // Tangent of Hertz's law, F ~ approach^1.5.
  const double stiffness = 1.5 * with_.load / with_.approach;
  placement_.centreZ += step_ * (width_ * patch.vertical - with_.load) / (stiffness * sinkingTime);
}

void RollingBlocks::press() {
  for (auto* state : {&displaced_, &target_, &velocity_}) std::fill(state->begin(), state->end(), 0.0);
  history_ = {};
  history_.traction.assign(2 * surfaces_.points(), 0.0);
  placement_ = {-with_.size / 2, with_.radius - 0.5 * with_.approach, 0, 0, 0};
  PatchState patch;
  for (double time = 0; time < 12 * sinkingTime; time += step_) step(0, 0, patch, nullptr);
}

// What stood one element ahead stands here now; the coarse stations by interpolation.
void RollingBlocks::moveBack() {
  for (int b = 0; b < 2; ++b) {
    const auto& block = blocks_[b];
    const auto& at = block.positions;
    const double by = b == 0 ? with_.size : with_.size / with_.radius;
    for (auto* state : {&displaced_, &velocity_})
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 3; ++c) {
          const auto line = block.line(state->data(), n, c);
          int from = 1;
          for (int s = 1; s < block.intervals; ++s) {
            while (from < block.intervals && at[from] < at[s] + by * (1 - 1e-9)) ++from;
            const double u = std::min(1.0, (at[s] + by - at[from - 1]) / (at[from] - at[from - 1]));
            line[s] = (1 - u) * line[from - 1] + u * line[from];
          }
        }
  }
  const std::size_t shift = static_cast<std::size_t>(surfaces_.columns) * 4;
  auto& traction = history_.traction;
  std::copy(traction.begin() + static_cast<std::ptrdiff_t>(2 * shift), traction.end(), traction.begin());
  std::fill(traction.end() - static_cast<std::ptrdiff_t>(2 * shift), traction.end(), 0.0);
  for (std::size_t& point : history_.closed) point -= shift;
  placement_.centreX -= with_.size, placement_.rotation -= with_.size / with_.radius;
}

RollingBlocks::Steady RollingBlocks::roll(double creepage, int elements) {
  const double half = with_.size / 2, rows = with_.plane ? 2 : 1;  // of points within half an element of the middle
  const double angularVelocity = with_.speed * (1 + creepage) / with_.radius;
  Steady found;
  PatchState patch;
  std::vector<PatchPoint> points;
  for (int element = 0; element < elements; ++element) {
    found = {};
    int samples = 0;
    for (; placement_.centreX < half; ++samples) {
      points.clear();
      step(with_.speed, angularVelocity, patch, element + 1 == elements ? &points : nullptr);
      found.load += width_ * patch.vertical, found.force -= width_ * patch.longitudinal;
      found.length += patch.length;
      for (const auto& p : points)
        if (std::abs(p.y) < half && !p.slips) found.stick += 2 * p.area / with_.size / rows;
    }
    moveBack();
    for (double* mean : {&found.load, &found.force, &found.length, &found.stick}) *mean /= samples;
    found.share = found.force / (with_.friction * found.load);
  }
  return found;
}

RollingBlocks::Steady RollingBlocks::settle(double creepage) {
  const int apart = static_cast<int>(std::ceil(1.1 * with_.halfAxis / with_.size));
  const double one = roll(creepage, 2 * apart).share, two = roll(creepage, apart).share;
  Steady found = roll(creepage, apart);
  const double before = two - one, last = found.share - two, ratio = last / before;
  if (std::abs(before) > 1e-4 && ratio > 0 && ratio < 0.8) found.share += last * ratio / (1 - ratio);
  found.force = found.share * with_.friction * found.load;
  return found;
}

}  // namespace squat::contact
