#include "simulation/EnergySums.h"

#include <algorithm>

#include "core/OrderedSum.h"
#include "elasticity/SweptTie.h"
#include "model/StaticOperator.h"

namespace squat::simulation {

namespace {

using elasticity::SweptBlock;

// Sum of term(at, s) over the stations s of a node; `at`: index of its first component there, the other two follow in
// chunks.
template <typename Term>
double alongStations(const SweptBlock& block, int node, const Term& term) {
  double sum = 0;
  for (int s = 0; s < block.stationCount; s += SweptBlock::chunk) {
    const std::size_t first = block.index(node, 0, s);
    const auto count = static_cast<std::size_t>(std::min(SweptBlock::chunk, block.stationCount - s));
    sum += sumInLanes(0, count, [&](std::size_t k) { return term(first + k, s + static_cast<int>(k)); });
  }
  return sum;
}

}  // namespace

EnergySums::EnergySums(const dynamics::Rolling& rolling) {
  constexpr int together = 16;
  const auto& blocks = rolling.model().blocks;
  std::vector<int> all;
  std::size_t rows = 0;
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
    all.push_back(b);
    firstRow_.push_back(rows);
    rows += static_cast<std::size_t>(blocks[b].nodes);
    for (int n = 0; n < blocks[b].nodes; n += together)
      groups_.push_back({b, n, std::min(blocks[b].nodes, n + together)});
  }
  rows_.resize(rows);
  const int threads = rolling.team().size();
  work_ = elasticity::partition(blocks, all, threads);
  for (int i = 0; i < threads; ++i) scratch_.push_back(std::make_unique<elasticity::KernelScratch>(blocks));
  force_.assign(rolling.model().stateSize, 0.0);
  std::size_t largest = 0;
  for (const auto& tie : rolling.model().ties) largest = std::max(largest, elasticity::tieWorkspace(tie));
  tieWorkspace_.assign(largest, 0.0);
}

template <typename Sum>
void EnergySums::forEachNode(ThreadTeam& team, const Sum& sum) {
  team.forEach(groups_.size(), [&](std::size_t i) {
    const auto& group = groups_[i];
    for (int n = group.first; n < group.last; ++n)
      rows_[firstRow_[static_cast<std::size_t>(group.block)] + static_cast<std::size_t>(n)] = sum(group.block, n);
  });
}

EnergySums::Solids EnergySums::quadratic(const dynamics::Rolling& rolling, AlignedVector& x) {
  const auto& model = rolling.model();
  auto& team = rolling.team();
  elasticity::refreshGhosts(model.blocks, x.data());
  for (const auto& tie : model.ties) interpolateSlaves(tie, model.blocks, x.data(), tieWorkspace_.data());
  team.run([&](int index) {
    const auto thread = static_cast<std::size_t>(index);
    elasticity::applySegments(work_[thread], model.blocks, rolling.kernels(), x.data(), force_.data(),
                              *scratch_[thread]);
  });
  elasticity::addIrregularStiffness(model.movedElements, x.data(), force_.data());
  model::addSleeperShapes(model, x.data(), force_.data());
  forEachNode(team, [&](int b, int n) {
    const auto& block = model.blocks[b];
    const double *u = x.data(), *f = force_.data();
    return std::array<double, 3>{alongStations(block, n, [&](std::size_t at, int) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) sum += u[at + c * SweptBlock::chunk] * f[at + c * SweptBlock::chunk];
      return sum;
    })};
  });
  Solids energies;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
    double sum = 0;
    for (int n = 0; n < model.blocks[b].nodes; ++n) sum += rows_[firstRow_[b] + static_cast<std::size_t>(n)][0];
    (b == model.rail                     ? energies.rail
     : b == model.rim || b == model.body ? energies.wheelset
                                         : energies.sleepers) += sum;
  }
  return energies;
}

double EnergySums::workOfWeight(const dynamics::Rolling& rolling, const AlignedVector& displacement) {
  const auto& model = rolling.model();
  const double g = model.scenario.motion.gravity;
  // Of every station, in its own basis.
  std::vector<std::array<std::vector<double>, 3>> gravity;
  for (const auto& block : model.blocks) {
    auto& own = gravity.emplace_back();
    for (auto& line : own) line.resize(static_cast<std::size_t>(block.stationCount));
    for (int s = 0; s < block.stationCount; ++s) {
      const bool turns = block.kind == elasticity::SweepKind::aroundAxis;
      const Eigen::Matrix3d basis =
          elasticity::localBasis(block, block.positions[s] - (turns ? rolling.state().rotation : 0));
      const Eigen::Vector3d local = basis.transpose() * Eigen::Vector3d(0, 0, -g);
      for (int c = 0; c < 3; ++c) own[c][s] = local[c];
    }
  }
  forEachNode(rolling.team(), [&](int b, int n) {
    const auto& block = model.blocks[b];
    const double* u = displacement.data();
    const double* mass = model.mass[b].data() + static_cast<std::size_t>(n) * block.stride;
    const auto& [along, second, third] = gravity[static_cast<std::size_t>(b)];
    const double *ga = along.data(), *gb = second.data(), *gc = third.data();
    return std::array<double, 3>{alongStations(block, n, [&](std::size_t at, int s) {
      return mass[s] *
             (ga[s] * u[at] + gb[s] * u[at + SweptBlock::chunk] + gc[s] * u[at + std::size_t{2} * SweptBlock::chunk]);
    })};
  });
  double sum = 0;
  for (const auto& row : rows_) sum += row[0];
  sum -= g * model.scenario.suspension.sprungMass * displacement[model.sprungZ];
  if (model.boxOnSpring()) sum -= g * model.scenario.wheelset.axleBoxMass * displacement[model.boxZ];
  return sum;
}

EnergySums::Motion EnergySums::motion(const dynamics::Rolling& rolling) {
  const auto& model = rolling.model();
  std::vector<model::TurnedStations> turned(model.blocks.size());
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (model.blocks[b].kind == elasticity::SweepKind::aroundAxis)
      turnStations(model.blocks[b], rolling.state().rotation, turned[b]);
  forEachNode(rolling.team(), [&](int b, int n) {
    const auto& block = model.blocks[b];
    const double* v = rolling.state().velocity.data();
    const double* mass = model.mass[b].data() + static_cast<std::size_t>(n) * block.stride;
    std::array<double, 3> row{};
    row[0] = alongStations(block, n, [&](std::size_t at, int s) {
      const double va = v[at], vb = v[at + SweptBlock::chunk], vc = v[at + std::size_t{2} * SweptBlock::chunk];
      return mass[s] * (va * va + vb * vb + vc * vc);
    });
    const auto& t = turned[static_cast<std::size_t>(b)];
    if (!t.sine.empty())
      row[1] = alongStations(block, n, [&](std::size_t at, int s) {
        return mass[s] * (t.cosine[s] * v[at] + t.sine[s] * v[at + SweptBlock::chunk]);
      });
    return row;
  });
  Motion motion;
  for (const auto& row : rows_) motion.energy += 0.5 * row[0], motion.momentum += row[1];
  return motion;
}

}  // namespace squat::simulation
