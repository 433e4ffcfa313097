#include "simulation/EnergyBalance.h"

#include <algorithm>
#include <cmath>

#include "core/OrderedSum.h"
#include "model/StaticOperator.h"

namespace squat::simulation {

namespace {

constexpr std::size_t kPackedHead = 20;  // numbers ahead of the entries: six sums, the first entry, the one begun

struct SolidEnergies {
  double rail = 0, wheelset = 0, sleepers = 0;
  double sum() const { return rail + wheelset + sleepers; }
};

// x . K x per kind of solid, K the bare solids.
SolidEnergies quadratic(const dynamics::Rolling& rolling, AlignedVector x) {
  const auto& model = rolling.model();
  auto& team = const_cast<dynamics::Rolling&>(rolling).team();
  elasticity::refreshGhosts(model.blocks, x.data());
  AlignedVector force(x.size(), 0.0), workspace;
  for (const auto& tie : model.ties) {
    workspace.assign(elasticity::tieWorkspace(tie), 0.0);
    interpolateSlaves(tie, model.blocks, x.data(), workspace.data());
  }
  std::vector<int> all;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) all.push_back(b);
  const auto work = elasticity::partition(model.blocks, all, team.size());
  team.run([&](int index) {
    elasticity::KernelScratch scratch(model.blocks);
    elasticity::applySegments(work[index], model.blocks, rolling.kernels(), x.data(), force.data(), scratch);
  });
  elasticity::addIrregularStiffness(model.movedElements, x.data(), force.data());
  model::addSleeperShapes(model, x.data(), force.data());
  SolidEnergies energies;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
    const auto& block = model.blocks[b];
    double sum = 0;
    for (int n = 0; n < block.nodes; ++n)
      for (int c = 0; c < 3; ++c) {
        const auto u = block.line(x.data(), n, c), f = block.line(force.data(), n, c);
        double own = 0;
        for (int s = 0; s < block.stationCount; ++s) own += u[s] * f[s];
        sum += own;
      }
    (b == model.rail                     ? energies.rail
     : b == model.rim || b == model.body ? energies.wheelset
                                         : energies.sleepers) += sum;
  }
  return energies;
}

double springEnergy(const dynamics::Rolling& rolling, const AlignedVector& u) {
  double sum = 0;
  for (const auto& set : rolling.model().forceElements) sum += forces::storedEnergy(set, u.data());
  return sum;
}

}  // namespace

EnergyBalance::EnergyBalance(const dynamics::Rolling& rolling, double startStrain)
    : reference_(startStrain), firstAngularVelocity_(rolling.state().angularVelocity) {}

double EnergyBalance::kineticEnergy(const dynamics::Rolling& rolling) const {
  const auto& model = rolling.model();
  const auto& state = rolling.state();
  const auto& d = model.scenario;
  double sum = 0, momentum = 0;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
    const auto& block = model.blocks[b];
    const bool turns = block.kind == elasticity::SweepKind::aroundAxis;
    model::TurnedStations turned;
    if (turns) turnStations(block, state.rotation, turned);
    for (int n = 0; n < block.nodes; ++n) {
      const double* m = model.mass[b].data() + n * block.stride;
      const double* v = state.velocity.data();
      const auto va = block.line(v, n, 0), vb = block.line(v, n, 1), vc = block.line(v, n, 2);
      double own = 0, along = 0;
      for (int s = 0; s < block.stationCount; ++s) {
        own += m[s] * (va[s] * va[s] + vb[s] * vb[s] + vc[s] * vc[s]);
        if (turns) along += m[s] * (turned.cosine[s] * va[s] + turned.sine[s] * vb[s]);
      }
      sum += 0.5 * own, momentum += along;
    }
  }
  const double vx = state.velocity[model.sprungX], vz = state.velocity[model.sprungZ];
  sum += 0.5 * d.suspension.sprungMass * (vx * vx + vz * vz);
  momentum += d.suspension.sprungMass * vx;
  if (model.boxOnSpring()) {
    const double boxX = state.velocity[model.boxX], boxZ = state.velocity[model.boxZ];
    sum += 0.5 * d.wheelset.axleBoxMass * (boxX * boxX + boxZ * boxZ);
    momentum += d.wheelset.axleBoxMass * boxX;
  }
  // Travel at the reference speed and rotation at the first angular velocity are taken off, exactly.
  const double rotation = 0.5 * model.wheelset.inertia * (state.angularVelocity - firstAngularVelocity_) *
                          (state.angularVelocity + firstAngularVelocity_);
  return sum + momentum * d.motion.speed + rotation;
}

void EnergyBalance::before(const dynamics::Rolling& rolling) {
  const auto& model = rolling.model();
  const AlignedVector u = rolling.displacement();
  const auto energies = quadratic(rolling, u);
  const auto damping = quadratic(rolling, rolling.state().velocity);
  const double springs = springEnergy(rolling, u);
  shares_ = {0.5 * energies.rail, 0.5 * energies.wheelset, 0.5 * energies.sleepers, springs};
  const AlignedVector weight = model::gravityForces(model, rolling.state().rotation);
  double fall = 0;
  for (std::size_t i = 0; i < u.size(); ++i) fall += weight[i] * u[i];
  const double power = rolling.beta() * damping.sum(), time = rolling.state().time;
  if (started_) materialDamping_ += 0.5 * (power + lastDampingPower_) * (time - lastTime_);
  lastDampingPower_ = power, lastTime_ = time;
  pending_ = {};
  addSums(rolling);
  pending_.kinetic = 0.5 * kineticEnergy(rolling);
  pending_.strain = 0.5 * energies.sum() + springs;
  pending_.damping += materialDamping_;
  pending_.external += fall;
  // Plastic strain: the solids' energy is that of the elastic strain alone, hardening stores a part of what flow takes.
  const auto flow = plasticity::layerEnergy(model.layer, rolling.state().plastic, rolling.layerForces(), u.data());
  shares_.rail += flow.elastic + flow.hardening;
  pending_.strain += flow.elastic + flow.hardening;
  pending_.plastic = flow.dissipated;
}

// Half the work of a step is done when its displacement stands.
void EnergyBalance::addSums(const dynamics::Rolling& rolling) {
  const auto& sums = rolling.state().sums;
  pending_.damping += 0.5 * sums.damping;
  pending_.external += 0.5 * sums.torqueWork;
}

void EnergyBalance::after(const dynamics::Rolling& rolling) {
  addSums(rolling);
  pending_.friction = rolling.state().sums.friction;  // of the slip that has led to this displacement
  pending_.kinetic += 0.5 * kineticEnergy(rolling);
  pending_.contact = rolling.view().patch.storedEnergy;
  if (!started_) first_ = pending_, started_ = true;
  samples_.push_back(pending_);
  time_.push_back(lastTime_);
}

double EnergyBalance::residual(const Sample& s) const {
  return (s.kinetic + s.strain + s.contact) - (first_.kinetic + first_.strain + first_.contact) +
         (s.friction + s.damping + s.plastic) - (first_.friction + first_.damping + first_.plastic) -
         (s.external - first_.external);
}

double EnergyBalance::relativeResidual() const {
  if (samples_.empty()) return 0;
  const auto& s = samples_.back();
  return residual(s) / (reference_ + s.friction + s.damping + s.plastic);
}

double EnergyBalance::largestRelativeResidual() const {
  double largest = 0;
  EnergyBalance copy = *this;
  copy.samples_.clear();
  for (const auto& sample : samples_) {
    copy.samples_.assign(1, sample);
    largest = std::max(largest, std::abs(copy.relativeResidual()));
  }
  return largest;
}

std::vector<results::Channel> EnergyBalance::channels() const {
  std::vector<results::Channel> list{{"kinetic", "J", "beyond that of the reference motion", {}},
                                     {"strain", "J", "elastic, solids and springs, and stored by hardening", {}},
                                     {"contact", "J", "stored in the penalties", {}},
                                     {"friction", "J", "dissipated by slip so far", {}},
                                     {"damping", "J", "dissipated by dashpots and material so far", {}},
                                     {"plastic", "J", "dissipated by plastic flow so far", {}},
                                     {"external", "J", "work of torque and weight so far", {}},
                                     {"residual", "J", "unbalanced energy", {}}};
  for (const auto& s : samples_) {
    const double values[8] = {
        s.kinetic, s.strain, s.contact, s.friction, s.damping, s.plastic, s.external - first_.external, residual(s)};
    for (int i = 0; i < 8; ++i) list[i].values.push_back(values[i]);
  }
  return list;
}

std::vector<double> EnergyBalance::pack() const {
  std::vector<double> numbers{reference_, firstAngularVelocity_, materialDamping_, lastDampingPower_,
                              lastTime_,  started_ ? 1.0 : 0.0};
  const auto put = [&](const Sample& s) {
    numbers.insert(numbers.end(), {s.kinetic, s.strain, s.contact, s.friction, s.damping, s.external, s.plastic});
  };
  put(first_), put(pending_);
  for (std::size_t i = 0; i < samples_.size(); ++i) numbers.push_back(time_[i]), put(samples_[i]);
  return numbers;
}

bool EnergyBalance::isPacked(const std::vector<double>& numbers) {
  return numbers.size() >= kPackedHead && (numbers.size() - kPackedHead) % 8 == 0;
}

void EnergyBalance::unpack(const std::vector<double>& numbers) {
  reference_ = numbers[0], firstAngularVelocity_ = numbers[1], materialDamping_ = numbers[2];
  lastDampingPower_ = numbers[3], lastTime_ = numbers[4], started_ = numbers[5] != 0;
  const auto get = [&](std::size_t at) {
    return Sample{numbers[at],     numbers[at + 1], numbers[at + 2], numbers[at + 3],
                  numbers[at + 4], numbers[at + 5], numbers[at + 6]};
  };
  first_ = get(6), pending_ = get(13);
  time_.clear(), samples_.clear();
  for (std::size_t at = kPackedHead; at + 8 <= numbers.size(); at += 8)
    time_.push_back(numbers[at]), samples_.push_back(get(at + 1));
}

}  // namespace squat::simulation
