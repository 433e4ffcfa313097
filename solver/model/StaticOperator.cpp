#include "model/StaticOperator.h"

#include <algorithm>
#include <cmath>

namespace squat::model {

namespace {

std::vector<unsigned char> findFree(const Model& model, bool fixSprungMassAlong) {
  std::vector<unsigned char> free(model.stateSize, 0);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n)
      for (int c = 0; c < 3; ++c)
        if (!model.slave[b][n] && model.freeMask[b][3 * n + c] != 0)
          for (int s = 0; s < block.stationCount; ++s) free[block.index(n, c, s)] = 1;
  }
  for (const auto index : model.fixed) free[index] = 0;
  free[model.sprungZ] = 1;
  free[model.sprungX] = fixSprungMassAlong ? 0 : 1;
  if (model.boxOnSpring()) free[model.boxX] = free[model.boxZ] = 1;
  return free;
}

// What the slaves' own diagonal adds to that of their masters, by the squares of the weights: as if the slaves of a
// master moved one by one. Without it, masters of a much finer block would look a tenth as stiff as they are.
void addTiedDiagonal(const elasticity::SweptTie& tie, const std::vector<elasticity::SweptBlock>& blocks,
                     double* diagonal) {
  const auto &slave = blocks[tie.slaveBlock], &master = blocks[tie.masterBlock];
  const auto& at = tie.stations;
  for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const auto own = slave.line(static_cast<const double*>(diagonal), tie.slaveNodes[i], c);
      for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e) {
        const auto to = master.line(diagonal, tie.columns[tie.entryColumn[e]].outer, c);
        const double weight2 = tie.entryWeight[e] * tie.entryWeight[e];
        for (int s = 0; s < slave.intervals; ++s) {
          to[at.left[s]] += weight2 * at.leftWeight[s] * at.leftWeight[s] * own[s];
          to[at.right[s]] += weight2 * at.rightWeight[s] * at.rightWeight[s] * own[s];
        }
      }
    }
}

}  // namespace

std::vector<std::pair<std::size_t, double>> hubTurn(const Model& model) {
  std::vector<std::pair<std::size_t, double>> terms;
  const auto& block = model.blocks[model.hub.block];
  for (std::size_t i = 0; i < model.hub.nodes.size(); ++i)
    for (int s = 0; s < block.stationCount; ++s)
      terms.push_back({block.index(model.hub.nodes[i], 0, s),
                       model.hub.weight[i] / block.stationCount / block.section.nodes[model.hub.nodes[i]][0]});
  return terms;
}

StaticOperator::StaticOperator(const Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                               double rotation, double rotationStiffness, bool fixSprungMassAlong)
    : model_(model), kernels_(kernels), team_(team), free_(findFree(model, fixSprungMassAlong)) {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i]) continue;
    if (notFree_.empty() || notFree_.back()[1] != i) notFree_.push_back({i, i});
    ++notFree_.back()[1];
  }
  std::vector<int> all;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) all.push_back(b);
  work_ = elasticity::partition(model.blocks, all, team.size());
  for (int i = 0; i < team.size(); ++i) scratch_.push_back(std::make_unique<elasticity::KernelScratch>(model.blocks));
  turnStations(model.blocks[model.body], rotation, turned_);
  journal_ = {{{model.journalZ, ringTerms(model, model.bearing, turned_, {0, 1})},
               {model.journalX, ringTerms(model, model.bearing, turned_, {1, 0})}}};
  for (const auto& set : model.forceElements) {
    if (!set.law) {
      const bool isStiff = std::any_of(set.stiffness.begin(), set.stiffness.end(), [](double k) { return k != 0; });
      if (isStiff) linear_.push_back(&set);
      continue;
    }
    tangents_.push_back({&set, set, std::vector<double>(set.size(), 0.0), std::vector<double>(set.size(), 0.0)});
    tangents_.back().set.law.reset();
  }
  const AlignedVector atRest(tangents_.empty() ? 0 : model.stateSize, 0.0);
  linearise(atRest.data());
  if (rotationStiffness > 0) rotationStiffness_.add(hubTurn(model), rotationStiffness, 0);
  std::size_t maximum = 0;
  for (const auto& tie : model.ties) maximum = std::max(maximum, elasticity::tieWorkspace(tie));
  for (int i = 0; i < team.size(); ++i) tieWorkspaces_.emplace_back(maximum, 0.0);
}

// One thread's share of the slave stations; the first one's holds station 0, to which ghosts belong.
void StaticOperator::placeTiedNodes(double* u, int index) {
  if (index == 0) {
    elasticity::refreshGhosts(model_.blocks, u);
    for (const auto& [dependent, terms] : journal_) {
      double mean = 0;
      for (const auto& [unknown, weight] : terms) mean += weight * u[unknown];
      u[dependent] = mean;
    }
  }
  for (const auto& tie : model_.ties) {
    const int stations = model_.blocks[tie.slaveBlock].stationCount;
    const elasticity::StationSpan own{stations * index / team_.size(), stations * (index + 1) / team_.size()};
    interpolateSlaves(tie, model_.blocks, u, tieWorkspaces_[static_cast<std::size_t>(index)].data(), own);
  }
}

void StaticOperator::fillSlaves(double* u) {
  for (int index = 0; index < team_.size(); ++index) placeTiedNodes(u, index);
}

void StaticOperator::passTieForces(double* r) {
  for (const auto& tie : model_.ties) {
    const auto &slave = model_.blocks[tie.slaveBlock], &master = model_.blocks[tie.masterBlock];
    elasticity::transferForces(
        tie, 1.0, [&](int i, int c) { return slave.line(r, tie.slaveNodes[i], c); },
        [&](int node, int c) { return master.line(r, node, c); }, tieWorkspaces_.back().data(), 0, master.stationCount,
        {{0, slave.stationCount}});
  }
}

void StaticOperator::addJournalForces(double* r) const {
  for (const auto& [dependent, terms] : journal_)
    for (const auto& [unknown, weight] : terms) r[unknown] += weight * r[dependent];
}

bool StaticOperator::linearise(const double* displacement) {
  bool isChanged = false;
  for (auto& [of, set, forceBeside, energyBeside] : tangents_)
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double q = set.elongation(i, displacement), tangent = of->tangent(i, q);
      isChanged = isChanged || tangent != set.stiffness[i];
      set.stiffness[i] = tangent;
      forceBeside[i] = of->elasticForce(i, q) - tangent * q;
      energyBeside[i] = of->storedEnergy(i, q) - 0.5 * tangent * q * q;
    }
  return isChanged;
}

void StaticOperator::stiffen() {
  for (auto& [of, set, forceBeside, energyBeside] : tangents_)
    for (std::size_t i = 0; i < set.size(); ++i) set.stiffness[i] = of->stiffestTangent(i);
}

void StaticOperator::addForcesBesideTangents(double* force) const {
  for (const auto& [of, set, forceBeside, energyBeside] : tangents_)
    for (std::size_t i = 0; i < set.size(); ++i)
      for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t)
        force[set.unknown[t]] -= set.weight[t] * forceBeside[i];
}

double StaticOperator::energyBesideTangents() const {
  double sum = 0;
  for (const auto& tangents : tangents_)
    for (const double energy : tangents.energyBeside) sum += energy;
  return sum;
}

void StaticOperator::clearNotFree(double* r, int index) const {
  const std::size_t stretches = notFree_.size(), parts = static_cast<std::size_t>(team_.size());
  const auto part = static_cast<std::size_t>(index);
  for (std::size_t i = stretches * part / parts; i < stretches * (part + 1) / parts; ++i)
    std::fill(r + notFree_[i][0], r + notFree_[i][1], 0.0);
}

void StaticOperator::reduceForces(double* r) {
  passTieForces(r);
  addJournalForces(r);
  for (int index = 0; index < team_.size(); ++index) clearNotFree(r, index);
}

void StaticOperator::apply(double* u, double* result) {
  team_.runInOrder(
      {[&](int index) { placeTiedNodes(u, index); },
       [&](int index) {
         elasticity::applySegments(work_[index], model_.blocks, kernels_, u, result, *scratch_[index]);
       },
       // Rail, sleepers and auxiliary unknowns on the one side; wheel body and the rim tied to it on the other.
       [&](int index) {
         if (index == 0) {
           std::fill(result + model_.firstAuxiliary, result + model_.stateSize, 0.0);
           elasticity::addIrregularStiffness(model_.movedElements, u, result);
           addSleeperShapes(model_, u, result);
           for (const auto* set : linear_) forces::addStiffness(*set, u, result);
           for (const auto& tangents : tangents_) forces::addStiffness(tangents.set, u, result);
         }
         if (index == team_.size() - 1) {
           forces::addStiffness(rotationStiffness_, u, result);
           passTieForces(result);
         }
       },
       [&](int index) {
         if (index > 0) return;
         forces::addStiffness(contact_, u, result);
         addJournalForces(result);
       },
       [&](int index) { clearNotFree(result, index); }});
}

AlignedVector StaticOperator::diagonal() const {
  AlignedVector diagonal(model_.stateSize, 0.0);
  for (const auto& block : model_.blocks) {
    const auto own = elasticity::stiffnessDiagonal(block);
    std::copy(own.begin(), own.end(), diagonal.begin() + static_cast<std::ptrdiff_t>(block.offset));
  }
  for (const auto& tie : model_.ties) addTiedDiagonal(tie, model_.blocks, diagonal.data());
  for (const auto* set : linear_) forces::addDiagonal(*set, diagonal.data());
  for (const auto& tangents : tangents_) forces::addDiagonal(tangents.set, diagonal.data());
  for (const auto* set : {&rotationStiffness_, &contact_}) forces::addDiagonal(*set, diagonal.data());
  for (const auto& [dependent, terms] : journal_)
    for (const auto& [unknown, weight] : terms) diagonal[unknown] += diagonal[dependent] * weight * weight;
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    if (!free_[i] || diagonal[i] <= 0) diagonal[i] = 1;
  return diagonal;
}

AlignedVector gravityForces(const Model& model, double rotation) {
  AlignedVector force(model.stateSize, 0.0);
  const double g = model.scenario.motion.gravity;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    for (int s = 0; s < block.stationCount; ++s) {
      const Eigen::Matrix3d basis = elasticity::localBasis(
          block, block.positions[s] - (block.kind == elasticity::SweepKind::aroundAxis ? rotation : 0));
      const Eigen::Vector3d local = basis.transpose() * Eigen::Vector3d(0, 0, -g);
      for (int n = 0; n < block.nodes; ++n)
        for (int c = 0; c < 3; ++c) force[block.index(n, c, s)] = local[c] * model.mass[b][n * block.stride + s];
    }
  }
  force[model.sprungZ] = -g * model.scenario.suspension.sprungMass;
  if (model.boxOnSpring()) force[model.boxZ] = -g * model.scenario.wheelset.axleBoxMass;
  return force;
}

}  // namespace squat::model
