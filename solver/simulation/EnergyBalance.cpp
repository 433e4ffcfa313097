#include "simulation/EnergyBalance.h"

#include <algorithm>
#include <cmath>

#include "model/WheelMotion.h"

namespace squat::simulation {

namespace {

constexpr std::size_t kPackedHead = 20;  // numbers ahead of the entries: six sums, the first entry, the one begun

double springEnergy(const dynamics::Rolling& rolling, const AlignedVector& u) {
  double sum = 0;
  for (const auto& set : rolling.model().forceElements) sum += forces::storedEnergy(set, u.data());
  return sum;
}

// Of the lateral suspension (Rolling::pushLaterally).
double lateralEnergy(const dynamics::Rolling& rolling, const std::vector<double>& outwards) {
  if (outwards.size() < 2) return 0;
  double stiffness = 0;
  for (const auto* side : rolling.sides()) stiffness += side->model().scenario.suspension.lateralStiffness;
  const double lateral = 0.5 * (outwards[0] - outwards[1]);
  return 0.5 * stiffness * lateral * lateral;
}

}  // namespace

EnergyBalance::EnergyBalance(const dynamics::Rolling& rolling, double startStrain)
    : reference_(startStrain), firstAngularVelocity_(rolling.state().angularVelocity) {
  for (const auto* side : rolling.sides()) sums_.emplace_back(*side);
}

double EnergyBalance::kineticEnergy(const dynamics::Rolling& rolling) {
  double sum = 0;
  for (std::size_t i = 0; i < sums_.size(); ++i) sum += kineticEnergy(*rolling.sides()[i], sums_[i]);
  if (!rolling.second()) return sum;
  std::vector<double> sprung;  // [m/s] of each side
  for (const auto* side : rolling.sides()) sprung.push_back(side->state().velocity[side->model().sprungZ]);
  return sum + rolling.second()->kineticEnergy(sprung);
}

double EnergyBalance::kineticEnergy(const dynamics::Rolling& rolling, EnergySums& sums) const {
  const auto& model = rolling.model();
  const auto& state = rolling.state();
  const auto& d = model.scenario;
  auto [sum, momentum] = sums.motion(rolling);
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
  double power = 0, plastic = 0, strain = 0, fall = 0;
  std::vector<double> outwards;  // [m] journals of each side
  shares_ = {};
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const auto& side = *rolling.sides()[i];
    side.displacement(displacement_);
    const auto energies = sums_[i].quadratic(side, displacement_);
    velocity_ = side.state().velocity;
    outwards.push_back(ringLateralMean(side.model(), side.model().bearing, displacement_.data()));
    power += side.beta() * sums_[i].quadratic(side, velocity_).sum();
    const double springs = springEnergy(side, displacement_);
    fall += sums_[i].workOfWeight(side, displacement_);
    // Plastic strain: the solids' energy is that of the elastic strain alone, hardening stores a part of what flow
    // takes.
    const auto flow =
        plasticity::layerEnergy(side.model().layer, side.state().plastic, side.layerForces(), displacement_.data());
    shares_.rail += 0.5 * energies.rail + (flow.elastic + flow.hardening);
    shares_.wheelset += 0.5 * energies.wheelset, shares_.sleepers += 0.5 * energies.sleepers,
        shares_.springs += springs;
    strain += 0.5 * energies.sum() + springs + (flow.elastic + flow.hardening);
    plastic += flow.dissipated;
  }
  const double lateral = lateralEnergy(rolling, outwards);
  shares_.springs += lateral, strain += lateral;
  if (const auto* second = rolling.second()) strain += second->strainEnergy(), fall += second->workOfWeight();
  const double time = rolling.state().time;
  if (started_) materialDamping_ += 0.5 * (power + lastDampingPower_) * (time - lastTime_);
  lastDampingPower_ = power, lastTime_ = time;
  pending_ = {};
  addSums(rolling);
  pending_.kinetic = 0.5 * kineticEnergy(rolling);
  pending_.strain = strain;
  pending_.damping += materialDamping_;
  pending_.external += fall;
  pending_.plastic = plastic;
}

// Half the work of a step is done when its displacement stands.
void EnergyBalance::addSums(const dynamics::Rolling& rolling) {
  for (const auto* side : rolling.sides()) {
    pending_.damping += 0.5 * side->state().sums.damping;
    pending_.external += 0.5 * side->state().sums.torqueWork;
  }
  if (const auto* second = rolling.second())
    pending_.damping += 0.5 * second->damped(), pending_.external += 0.5 * second->driven();
}

void EnergyBalance::after(const dynamics::Rolling& rolling) {
  addSums(rolling);
  for (const auto* side : rolling.sides()) {
    pending_.friction += side->state().sums.friction;  // of the slip that has led to this displacement
    pending_.contact += side->view().patch.storedEnergy;
  }
  if (const auto* second = rolling.second()) pending_.contact += second->contactEnergy();
  pending_.kinetic += 0.5 * kineticEnergy(rolling);
  if (!started_) first_ = pending_, started_ = true;
  samples_.push_back(pending_);
  time_.push_back(lastTime_);
}

double EnergyBalance::residual(const Sample& s) const {
  return (s.kinetic + s.strain + s.contact) - (first_.kinetic + first_.strain + first_.contact) +
         (s.friction + s.damping + s.plastic) - (first_.friction + first_.damping + first_.plastic) -
         (s.external - first_.external);
}

double EnergyBalance::relativeResidual() const { return samples_.empty() ? 0 : relativeResidual(samples_.back()); }

double EnergyBalance::relativeResidual(const Sample& s) const {
  return residual(s) / (reference_ + s.friction + s.damping + s.plastic);
}

double EnergyBalance::largestRelativeResidual() const {
  double largest = 0;
  for (const auto& sample : samples_) largest = std::max(largest, std::abs(relativeResidual(sample)));
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
