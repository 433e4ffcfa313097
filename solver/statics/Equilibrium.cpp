#include "statics/Equilibrium.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/Errors.h"
#include "core/OrderedSum.h"
#include "model/ContactPenalty.h"
#include "statics/ConjugateGradients.h"
#include "statics/VehicleMotion.h"

namespace squat::statics {

namespace {

constexpr double patchReach = 0.022;  // [m] along the rail, far beyond any patch
constexpr double nearGap = 1.2e-3;    // [m] undeformed gap that a deflection of the track may close

struct ClosedContact {
  forces::ForceElements springs;                // tangent of the closed points
  std::vector<double> penetration;              // of each spring
  std::vector<std::array<double, 2>> location;  // x relative to the wheel, y
  double vertical = 0, lateral = 0;             // [N] on the rail, downwards and outwards positive
};

ClosedContact evaluateContact(const model::Model& model, const model::TurnedStations& turned, const double* u,
                              double wheelX, double rotation, double penalty) {
  const auto& s = model.surfaces;
  const auto &rail = model.blocks[model.rail], &rim = model.blocks[model.rim];
  const auto hub = ringMean(model, model.centre, turned, u);
  const contact::WheelPlacement wheel{wheelX, model.wheelset.centreHeight, rotation, hub.x, hub.z};
  ClosedContact closed;
  // A wheel that is not round may stand on two places with nothing between them.
  const double reach = s.treadCurve.empty() ? patchReach : std::max(patchReach, s.reach);
  const auto [first, last] = contact::reachableIntervals(s, rail, wheelX, reach);
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        contact::TouchPoint t;
        if (!evaluatePoint(s, rail, rim, u, wheel, i, j, point, nearGap, t) || t.penetration <= 0) continue;
        closed.springs.add(contact::penetrationTerms(s, rail, rim, t), penalty * s.area[t.point], 0);
        closed.penetration.push_back(t.penetration);
        closed.location.push_back({s.pointX[t.point] - wheelX, s.pointY[t.point]});
        const double force = penalty * s.area[t.point] * t.penetration;
        closed.vertical += force * s.treadCosine * t.cosine;
        closed.lateral += force * s.treadSine;
      }
  return closed;
}

// How far the rigid wheel overlaps the rigid rail [m]; negative where its tread has less than the nominal radius.
double rigidOverlap(const model::Model& model, double wheelX, double rotation) {
  const auto& s = model.surfaces;
  if (s.treadCurve.empty()) return 0;
  const auto &rail = model.blocks[model.rail], &rim = model.blocks[model.rim];
  const AlignedVector rest(model.stateSize, 0.0);
  const contact::WheelPlacement wheel{wheelX, model.wheelset.centreHeight, rotation, 0, 0};
  double largest = -1;  // [m]
  const auto [first, last] = contact::reachableIntervals(s, rail, wheelX, s.reach);
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int point = 0; point < 4; ++point) {
        contact::TouchPoint t;
        constexpr double anywhere = 0.1;  // [m]
        if (!evaluatePoint(s, rail, rim, rest.data(), wheel, i, j, point, anywhere, t)) continue;
        largest = std::max(largest, t.penetration / (s.treadCosine * t.cosine));
      }
  return largest;
}

void addContactForces(const ClosedContact& closed, double* r) {
  for (std::size_t i = 0; i < closed.springs.size(); ++i) {
    const double force = closed.springs.stiffness[i] * closed.penetration[i];
    for (std::size_t t = closed.springs.start[i]; t < closed.springs.start[i + 1]; ++t)
      r[closed.springs.unknown[t]] -= closed.springs.weight[t] * force;
  }
}

void describePatch(const ClosedContact& closed, Equilibrium& e) {
  double n = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  for (std::size_t i = 0; i < closed.springs.size(); ++i) {
    const double force = closed.springs.stiffness[i] * closed.penetration[i];
    n += force;
    x1 += force * closed.location[i][0], y1 += force * closed.location[i][1];
    x2 += force * closed.location[i][0] * closed.location[i][0],
        y2 += force * closed.location[i][1] * closed.location[i][1];
  }
  e.halfAxisRolling = std::sqrt(5 * std::max(0.0, x2 / n - x1 * x1 / n / n));
  e.halfAxisLateral = std::sqrt(5 * std::max(0.0, y2 / n - y1 * y1 / n / n));
  e.centreLateral = y1 / n;
  const double axes = e.halfAxisRolling * e.halfAxisLateral;  // 0 where the points stand in one line
  e.peakPressure = axes > 0 ? 3 * n / (2 * std::numbers::pi * axes) : 0;
}

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

// Displacements of all nodes without the mean rotation, strain energy beside the contact's, approach.
void complete(const model::Model& model, model::StaticOperator& op, Equilibrium& e) {
  op.fillSlaves(e.displacement.data());
  model::removeMeanRotation(model, model::meanRotation(model, e.displacement.data()), e.displacement.data());
  op.fillSlaves(e.displacement.data());
  op.contactSprings() = {};
  AlignedVector copy = e.displacement, forces(e.displacement.size(), 0.0);
  op.apply(copy.data(), forces.data());
  for (std::size_t i = 0; i < copy.size(); ++i) e.strainEnergy += 0.5 * copy[i] * forces[i];
  e.strainEnergy += op.energyBesideTangents();
  const auto hub = ringMean(model, model.centre, op.turned(), e.displacement.data());
  e.approach = railDeflection(model, e.displacement, e.wheelX) - hub.z;
}

}  // namespace

Equilibrium findEquilibrium(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                            double wheelX, double rotation, const EquilibriumOptions& options, Monitor& monitor) {
  Equilibrium e;
  e.wheelX = wheelX, e.rotation = rotation;
  const auto& d = model.scenario;
  const double load = d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
  const double penalty = model::normalPenalty(d);
  // Any stiffness fixes the rotation; this one is of the order of the contact's.
  model::StaticOperator op(model, kernels, team, rotation, 1e8, true);
  CoarseSpace coarse(model, op);
  const std::size_t n = model.stateSize;
  e.rigidHeight = rigidOverlap(model, wheelX, rotation);
  e.displacement.assign(n, 0.0);
  if (options.guess)
    e.displacement = *options.guess;
  else
    addVerticalMotion(model, rotation, e.rigidHeight - 1e-4, e.displacement);  // closes the contact
  const AlignedVector weight = gravityForces(model, rotation);
  if (!coarse.assemble(op, monitor)) {
    e.cancelled = true;
    return e;
  }

  e.coarseStiffness = coarse.stiffness();
  AlignedVector r(n, 0.0), change(n, 0.0);
  double startNorm = 0;
  std::size_t closedBefore = 0;
  while (true) {
    op.contactSprings() = {};
    const bool hasNewTangents = op.linearise(e.displacement.data());
    op.apply(e.displacement.data(), r.data());
    ClosedContact closed = evaluateContact(model, op.turned(), e.displacement.data(), wheelX, rotation, penalty);
    if (closed.springs.size() == 0) throw RunError("the wheel finds no contact in the equilibrium", 0, 0, "contact");
    for (std::size_t i = 0; i < n; ++i) r[i] = weight[i] - r[i];
    addContactForces(closed, r.data());
    op.addForcesBesideTangents(r.data());
    op.reduceForces(r.data());
    const double norm = normOf(r, team);
    e.residual = norm / load;
    e.contactForce = closed.vertical, e.lateralForce = closed.lateral;
    if (e.newtonSteps == 0) startNorm = norm;
    if (e.residual < options.tolerance) {
      describePatch(closed, e);
      for (std::size_t i = 0; i < closed.springs.size(); ++i)
        e.strainEnergy += 0.5 * closed.springs.stiffness[i] * closed.penetration[i] * closed.penetration[i];
      break;
    }
    checkConvergence(e, norm, options);
    op.contactSprings() = closed.springs;
    coarse.factorise(closed.springs);
    // Inexact Newton: no better than the set of closed points is known, which shrinks to the true one, and the tangents
    // of the force elements.
    const auto count = static_cast<double>(closed.springs.size());
    const auto before = static_cast<double>(std::exchange(closedBefore, closed.springs.size()));
    const double changed = std::abs(count - before) / count;
    const double forcing = changed > 0.03 ? 0.2 : changed > 0.005 || hasNewTangents ? 1e-2 : 1e-5;
    const double goal = std::max(0.3 * options.tolerance * load, norm * forcing);
    const auto solution = conjugateGradients(
        op, coarse, r, change, goal, options.maximumIterations - e.iterations, [&](int, double residual) {
          Progress progress;
          progress.phase = "equilibrium";
          const double all = std::log(std::max(startNorm, load) / (options.tolerance * load));
          progress.fraction =
              std::clamp(1 - std::log(std::max(residual, 1e-300) / (options.tolerance * load)) / all, 0.0, 1.0);
          monitor.report(progress);
          return !monitor.cancelled();
        });
    e.iterations += solution.iterations;
    ++e.newtonSteps;
    if (solution.cancelled) {
      e.cancelled = true;
      return e;
    }
    for (std::size_t i = 0; i < n; ++i) e.displacement[i] += change[i];
  }
  complete(model, op, e);
  e.approach += e.rigidHeight;
  return e;
}

namespace {

// Weight less inner and contact forces of displacements given in the bases of rotation zero, in those bases.
AlignedVector residualAt(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                         AlignedVector u, double wheelX, double rotation) {
  model::StaticOperator op(model, kernels, team, rotation, 1e8, true);
  model::turnBases(model, rotation, u);
  op.linearise(u.data());
  AlignedVector r(u.size(), 0.0);
  op.apply(u.data(), r.data());
  const auto closed =
      evaluateContact(model, op.turned(), u.data(), wheelX, rotation, model::normalPenalty(model.scenario));
  const AlignedVector weight = gravityForces(model, rotation);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = weight[i] - r[i];
  addContactForces(closed, r.data());
  op.addForcesBesideTangents(r.data());
  op.reduceForces(r.data());
  model::turnBases(model, -rotation, r);
  return r;
}

}  // namespace

AlignedVector equilibriumRate(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                              const Equilibrium& e, Monitor& monitor) {
  // Small against an element, large against round-off: the residual changes by some kN a millimetre.
  const double distance = 1e-2 * model.scenario.mesh.contactSize;
  const double turn = distance / model.surfaces.radius;
  AlignedVector change = residualAt(model, kernels, team, e.displacement, e.wheelX + distance, turn);
  const AlignedVector behind = residualAt(model, kernels, team, e.displacement, e.wheelX - distance, -turn);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = (change[i] - behind[i]) / (2 * distance);

  model::StaticOperator op(model, kernels, team, 0, 1e8, true);
  op.linearise(e.displacement.data());
  CoarseSpace coarse(model, op);
  if (e.coarseStiffness.rows() == coarse.size())
    coarse.adopt(e.coarseStiffness);
  else if (!coarse.assemble(op, monitor))
    return AlignedVector(change.size(), 0.0);
  op.contactSprings() =
      evaluateContact(model, op.turned(), e.displacement.data(), e.wheelX, 0, model::normalPenalty(model.scenario))
          .springs;
  coarse.factorise(op.contactSprings());
  op.reduceForces(change.data());
  double norm2 = 0;
  for (const double value : change) norm2 += value * value;
  AlignedVector rate(change.size(), 0.0);
  // So that what is left of the residual shakes the wheel no more than what is left of the equilibrium's.
  const double target = 1e-5 * std::sqrt(norm2);
  const auto solution = conjugateGradients(op, coarse, change, rate, target, 20000, [&](int, double residual) {
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
  op.fillSlaves(rate.data());
  return rate;
}

}  // namespace squat::statics
