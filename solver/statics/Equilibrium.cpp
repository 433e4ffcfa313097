#include "statics/Equilibrium.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/Errors.h"
#include "core/OrderedSum.h"
#include "statics/ConjugateGradients.h"
#include "statics/StaticContact.h"
#include "statics/VehicleMotion.h"

namespace squat::statics {

namespace {

// Vertical displacement of the rail section under the wheel, mean over its nodes' masses.
double railDeflection(const model::Model& model, const AlignedVector& u, double x) {
  const auto& rail = model.blocks[model.rail];
  const auto it = std::upper_bound(rail.positions.begin(), rail.positions.end(), x);
  const int s = std::clamp(static_cast<int>(it - rail.positions.begin()) - 1, 0, rail.intervals);
  return verticalOfRailSection(model, u, s);
}

double normOf(const AlignedVector& r, ThreadTeam& team) {
  return std::sqrt(orderedSum(team, r.size(), [&](std::size_t begin, std::size_t end) {
    return sumInLanes(begin, end, [&](std::size_t i) { return r[i] * r[i]; });
  }));
}

void checkConvergence(const Equilibrium& e, double norm, const EquilibriumOptions& options) {
  if (!std::isfinite(norm)) throw RunError("the equilibrium is not a number", 0, 0, "equilibrium");
  if (e.newtonSteps >= options.maximumNewtonSteps || e.iterations >= options.maximumIterations)
    throw RunError("the equilibrium does not converge: residual " + std::to_string(e.residual) + " of the load after " +
                       std::to_string(e.newtonSteps) + " Newton steps and " + std::to_string(e.iterations) +
                       " iterations",
                   0, 0, "equilibrium");
}

double weightOnRail(const model::Model& model) {
  const auto& d = model.scenario;
  return d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
}

// [N] To which residuals are relative.
double loadOf(const StaticSystem& system) {
  double sum = 0;
  for (const auto& half : system.halves()) sum += weightOnRail(half.model) * weightOnRail(half.model);
  return std::sqrt(sum);
}

// What is not in balance at displacements `u`, and the contact there.
struct Unbalanced {
  AlignedVector force;  // of all halves
  std::vector<ClosedContact> closed;
  bool hasNewTangents = false;
};

// Weight less inner and contact forces; `weight` of all halves, all in the bases of the system's rotation. Leaves the
// halves without contact springs and with the tangents of `u`.
void findUnbalanced(StaticSystem& system, AlignedVector& u, const AlignedVector& weight, double wheelX,
                    Unbalanced& unbalanced) {
  auto& r = unbalanced.force;
  unbalanced.closed.clear(), unbalanced.hasNewTangents = false;
  for (const auto& half : system.halves()) {
    half.op->contactSprings() = {};
    unbalanced.hasNewTangents = half.op->linearise(u.data() + half.offset) || unbalanced.hasNewTangents;
  }
  system.apply(u.data(), r.data());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = weight[i] - r[i];
  for (const auto& half : system.halves()) {
    double* own = r.data() + half.offset;
    unbalanced.closed.push_back(
        evaluateContact(half.model, half.op->turned(), u.data() + half.offset, wheelX, system.rotation()));
    addContactForces(unbalanced.closed.back(), own);
    half.op->addForcesBesideTangents(own);
    half.op->reduceForces(own);
  }
  system.join(r.data());
}

// Of everything; a bogie's second wheelset, whose load needs no equation, stands on the rails at its distance from
// the wheel.
AlignedVector weightOf(const StaticSystem& system, double wheelX) {
  AlignedVector weight(system.size(), 0.0);
  std::vector<const scenario::Scenario*> sides;
  for (const auto& half : system.halves()) {
    const auto own = model::gravityForces(half.model, system.rotation());
    std::copy(own.begin(), own.end(), weight.begin() + static_cast<std::ptrdiff_t>(half.offset));
    sides.push_back(&half.model.scenario);
  }
  if (!system.halves().front().model.second) return weight;
  const auto loads = model::secondLoads(sides);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto& half = system.halves()[i];
    model::SecondRailSeat seat(half.model);
    seat.moveTo(wheelX + half.model.second->offset);
    seat.addToState(-loads[i], weight.data() + half.offset);
  }
  return weight;
}

// Displacements at which every wheel is in contact.
AlignedVector firstGuess(const StaticSystem& system, const std::vector<Equilibrium>& found,
                         const AlignedVector* guess) {
  AlignedVector u(system.size(), 0.0);
  double height = found.front().rigidHeight;
  for (const auto& e : found) height = std::min(height, e.rigidHeight);
  if (guess)
    u = *guess;
  else
    for (const auto& half : system.halves())
      addVerticalMotion(half.model, system.rotation(), height - 1e-4, u.data() + half.offset);
  return u;
}

// Displacements of all nodes without the mean rotation, strain energy beside the contact's, approach.
void complete(StaticSystem& system, AlignedVector& u, std::vector<Equilibrium>& found) {
  double turn = 0;
  for (const auto& half : system.halves()) {
    half.op->fillSlaves(u.data() + half.offset);
    turn += model::meanRotation(half.model, u.data() + half.offset);
  }
  turn /= static_cast<double>(system.halves().size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& half = system.halves()[i];
    auto& e = found[i];
    double* own = u.data() + half.offset;
    model::removeMeanRotation(half.model, turn, own);
    half.op->fillSlaves(own);
    half.op->contactSprings() = {};
    e.displacement.assign(own, own + half.model.stateSize);
    AlignedVector copy = e.displacement, forces(e.displacement.size(), 0.0);
    half.op->apply(copy.data(), forces.data());
    for (std::size_t k = 0; k < copy.size(); ++k) e.strainEnergy += 0.5 * copy[k] * forces[k];
    e.strainEnergy += half.op->energyBesideTangents();
    const auto hub = ringMean(half.model, half.model.centre, half.op->turned(), e.displacement.data());
    e.approach = railDeflection(half.model, e.displacement, e.wheelX) - hub.z + e.rigidHeight;
  }
  found.front().strainEnergy += system.energyBetween(u.data());
}

std::size_t pointsOf(const std::vector<ClosedContact>& closed) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const std::string wheel = closed.size() == 1 ? "the wheel" : i == 0 ? "the left wheel" : "the right wheel";
    if (closed[i].springs.size() == 0) throw RunError(wheel + " finds no contact in the equilibrium", 0, 0, "contact");
    count += closed[i].springs.size();
  }
  return count;
}

void describeContact(const Unbalanced& unbalanced, double residual, std::vector<Equilibrium>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].residual = residual;
    found[i].contactForce = unbalanced.closed[i].vertical, found[i].lateralForce = unbalanced.closed[i].lateral;
  }
}

// Inexact Newton: no better than the set of closed points is known, which shrinks to the true one, and the tangents of
// the force elements.
double forcingTerm(std::size_t points, std::size_t pointsBefore, bool hasNewTangents) {
  const auto count = static_cast<double>(points);
  const double changed = std::abs(count - static_cast<double>(pointsBefore)) / count;
  return changed > 0.03 ? 0.2 : changed > 0.005 || hasNewTangents ? 1e-2 : 1e-5;
}

}  // namespace

std::vector<Equilibrium> findEquilibria(StaticSystem& system, double wheelX, const EquilibriumOptions& options,
                                        Monitor& monitor) {
  std::vector<Equilibrium> found(system.halves().size());
  auto& common = found.front();
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].wheelX = wheelX, found[i].rotation = system.rotation();
    found[i].rigidHeight = rigidOverlap(system.halves()[i].model, wheelX, system.rotation());
  }
  const auto cancelled = [&] {
    for (auto& e : found) e.cancelled = true;
    return found;
  };
  const double load = loadOf(system);
  AlignedVector u = firstGuess(system, found, options.guess), change(system.size(), 0.0);
  const AlignedVector weight = weightOf(system, wheelX);
  if (!system.assemble(monitor)) return cancelled();

  Unbalanced unbalanced{AlignedVector(system.size(), 0.0), {}};
  double startNorm = 0;
  std::size_t pointsBefore = 0;
  while (true) {
    findUnbalanced(system, u, weight, wheelX, unbalanced);
    const std::size_t points = pointsOf(unbalanced.closed);
    const double norm = normOf(unbalanced.force, system.team());
    describeContact(unbalanced, norm / load, found);
    if (common.newtonSteps == 0) startNorm = norm;
    if (common.residual < options.tolerance) break;
    checkConvergence(common, norm, options);
    for (std::size_t i = 0; i < found.size(); ++i)
      system.halves()[i].op->contactSprings() = unbalanced.closed[i].springs;
    system.factorise();
    const double forcing = forcingTerm(points, std::exchange(pointsBefore, points), unbalanced.hasNewTangents);
    const double goal = std::max(0.3 * options.tolerance * load, norm * forcing);
    const auto solution =
        conjugateGradients(system, unbalanced.force, change, goal, options.maximumIterations - common.iterations,
                           [&](int, double residual) {
                             Progress progress;
                             progress.phase = "equilibrium";
                             const double all = std::log(std::max(startNorm, load) / (options.tolerance * load));
                             progress.fraction = std::clamp(
                                 1 - std::log(std::max(residual, 1e-300) / (options.tolerance * load)) / all, 0.0, 1.0);
                             monitor.report(progress);
                             return !monitor.cancelled();
                           });
    for (auto& e : found) e.iterations += solution.iterations, ++e.newtonSteps;
    if (solution.cancelled) return cancelled();
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += change[i];
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    describePatch(unbalanced.closed[i], found[i]);
    found[i].strainEnergy += storedEnergy(unbalanced.closed[i]);
  }
  complete(system, u, found);
  return found;
}

Equilibrium findEquilibrium(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                            double wheelX, double rotation, const EquilibriumOptions& options, Monitor& monitor) {
  HalfSystem system(model, kernels, team, rotation);
  return findEquilibria(system, wheelX, options, monitor).front();
}

namespace {

void turnHalves(const StaticSystem& system, double rotation, AlignedVector& state) {
  for (const auto& half : system.halves()) {
    AlignedVector own(state.begin() + static_cast<std::ptrdiff_t>(half.offset),
                      state.begin() + static_cast<std::ptrdiff_t>(half.offset + half.model.stateSize));
    model::turnBases(half.model, rotation, own);
    std::copy(own.begin(), own.end(), state.begin() + static_cast<std::ptrdiff_t>(half.offset));
  }
}

// What displacements given in the bases of rotation zero leave unbalanced once the wheel has turned by `rotation`, in
// those bases.
AlignedVector unbalancedAt(const StaticSystem& system, AlignedVector u, double wheelX, double rotation) {
  const auto turned = system.turnedBy(rotation);
  turnHalves(system, rotation, u);
  Unbalanced unbalanced{AlignedVector(system.size(), 0.0), {}};
  findUnbalanced(*turned, u, weightOf(*turned, wheelX), wheelX, unbalanced);
  turnHalves(system, -rotation, unbalanced.force);
  return std::move(unbalanced.force);
}

}  // namespace

AlignedVector equilibriumRate(StaticSystem& system, const std::vector<Equilibrium>& found, Monitor& monitor) {
  const double wheelX = found.front().wheelX;
  AlignedVector u(system.size(), 0.0);
  for (std::size_t i = 0; i < found.size(); ++i)
    std::copy(found[i].displacement.begin(), found[i].displacement.end(),
              u.begin() + static_cast<std::ptrdiff_t>(system.halves()[i].offset));
  // Small against an element, large against round-off: the residual changes by some kN a millimetre.
  const double distance = 1e-2 * system.halves().front().model.scenario.mesh.contactSize;
  const double turn = distance / system.rollingRadius();
  AlignedVector change = unbalancedAt(system, u, wheelX + distance, turn);
  const AlignedVector behind = unbalancedAt(system, u, wheelX - distance, -turn);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = (change[i] - behind[i]) / (2 * distance);

  for (const auto& half : system.halves()) {
    const double* own = u.data() + half.offset;
    half.op->linearise(own);
    half.op->contactSprings() = evaluateContact(half.model, half.op->turned(), own, wheelX, 0).springs;
    half.op->reduceForces(change.data() + half.offset);
  }
  system.join(change.data());
  system.factorise();
  double norm2 = 0;
  for (const double value : change) norm2 += value * value;
  AlignedVector rate(change.size(), 0.0);
  // So that what is left of the residual shakes the wheel no more than what is left of the equilibrium's.
  const double target = 1e-5 * std::sqrt(norm2);
  const auto solution = conjugateGradients(system, change, rate, target, 20000, [&](int, double residual) {
    Progress progress;
    progress.phase = "initial velocities";
    progress.fraction = std::clamp(std::log(std::sqrt(norm2) / std::max(residual, 1e-300)) / std::log(1e5), 0.0, 1.0);
    monitor.report(progress);
    return !monitor.cancelled();
  });
  if (!solution.cancelled && !(solution.residual <= target))
    throw RunError(
        "the initial velocities do not converge after " + std::to_string(solution.iterations) + " iterations", 0, 0,
        "equilibrium");
  for (const auto& half : system.halves()) half.op->fillSlaves(rate.data() + half.offset);
  return rate;
}

}  // namespace squat::statics
