#include "dynamics/StableStep.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/DenseAlgebra.h"
#include "core/OrderedSum.h"
#include "dynamics/ContactInertia.h"
#include "elasticity/SelectiveMassScaling.h"
#include "model/StaticOperator.h"

namespace squat::dynamics {

namespace {

constexpr double safety = 0.95;  // Lanczos values approach from below

// Accelerations of the model: inverse mass of every free unknown, zero elsewhere, and the inertia of short waves, or
// without that.
enum class ShortWaves { slowed, asTheyAre };
class Accelerations {
 public:
  Accelerations(const model::Model& model, model::StaticOperator& op, ShortWaves shortWaves)
      : model_(model), shortWaves_(shortWaves), inverse_(model.stateSize, 0.0) {
    const auto& free = op.freeUnknowns();
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const auto& block = model.blocks[b];
      for (int node = 0; node < block.nodes; ++node)
        for (int c = 0; c < 3; ++c)
          for (int s = 0; s < block.stationCount; ++s) {
            const std::size_t i = block.index(node, c, s);
            if (free[i]) inverse_[i] = model.inverseMass[b][static_cast<std::size_t>(node) * block.stride + s];
          }
    }
  }

  // F M^-1 f, or M^-1 f.
  void find(const AlignedVector& force, AlignedVector& acceleration) const {
    for (std::size_t i = 0; i < inverse_.size(); ++i) acceleration[i] = force[i] * inverse_[i];
    if (shortWaves_ == ShortWaves::asTheyAre) return;
    for (const auto& block : model_.blocks) elasticity::slowShortWaves(block, acceleration.data() + block.offset);
  }

  // Forces at random, as large in proportion as what they move.
  AlignedVector anyForce() const {
    AlignedVector force(inverse_.size(), 0.0);
    std::uint64_t seed = 88172645463325252U;
    for (std::size_t i = 0; i < force.size(); ++i) {
      seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
      const double value = static_cast<double>(seed >> 11) / 9007199254740992.0 - 0.5;
      if (inverse_[i] > 0) force[i] = value / std::sqrt(inverse_[i]);
    }
    return force;
  }

 private:
  const model::Model& model_;
  ShortWaves shortWaves_;
  AlignedVector inverse_;
};

double largestOf(const std::vector<double>& diagonal, const std::vector<double>& side) {
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  return algebra::largestOfTridiagonal(Vector(diagonal.data(), static_cast<Eigen::Index>(diagonal.size())),
                                       Vector(side.data(), static_cast<Eigen::Index>(side.size())));
}

struct Highest {
  double value = 0;  // [rad2/s2] of M^-1 K
  int iterations = 0;
};

// Lanczos in the inner product of the effective mass M_e: shapes v and their momenta M_e v, v_i . M_e v_j = 1 or 0.
Highest highestEigenvalue(model::StaticOperator& op, const Accelerations& accelerations, Monitor& monitor) {
  ThreadTeam& team = op.team();
  AlignedVector momentum = accelerations.anyForce();
  const std::size_t n = momentum.size();
  AlignedVector before(n, 0.0), shape(n, 0.0), rest(n, 0.0), next(n, 0.0);
  const auto product = [&](const AlignedVector& a, const AlignedVector& b) {
    return orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      return sumInLanes(begin, end, [&](std::size_t i) { return a[i] * b[i]; });
    });
  };
  const auto scale = [&](const AlignedVector& momenta, const AlignedVector& shapes, double size) {
    for (std::size_t i = 0; i < n; ++i) momentum[i] = momenta[i] / size, shape[i] = shapes[i] / size;
  };
  accelerations.find(momentum, next);
  scale(momentum, next, std::sqrt(product(momentum, next)));
  Highest highest;
  std::vector<double> alpha, beta;
  for (int k = 0; k < 400; ++k) {
    op.apply(shape.data(), rest.data());
    const double a = product(shape, rest), last = beta.empty() ? 0 : beta.back();
    for (std::size_t i = 0; i < n; ++i) rest[i] -= a * momentum[i] + last * before[i];
    accelerations.find(rest, next);
    const double b = std::sqrt(std::max(0.0, product(next, rest)));
    alpha.push_back(a);
    highest.iterations = k + 1;
    if (k % 10 == 9 || b < 1e-12 * a) {
      const double previous = std::exchange(highest.value, largestOf(alpha, beta));
      Progress progress;
      progress.phase = "stable step", progress.fraction = std::min(1.0, k / 100.0);
      monitor.report(progress);
      if (std::abs(highest.value - previous) < 1e-4 * highest.value || monitor.cancelled() || b < 1e-12 * a) break;
    }
    beta.push_back(b);
    before.swap(momentum);
    scale(rest, next, b);
  }
  return highest;
}

// Where the highest modes sit: the unknown that moves most in a random motion from which a Chebyshev polynomial of
// M^-1 K has taken the modes below 0.9 of the highest eigenvalue; degree 20 makes the highest 10^5 times as large.
std::size_t whereHighest(model::StaticOperator& op, const Accelerations& accelerations, double eigenvalue) {
  const double middle = 0.45 * eigenvalue;  // of the part that is taken away, and half its length
  AlignedVector force = accelerations.anyForce();
  const std::size_t n = force.size();
  AlignedVector before(n, 0.0), shape(n, 0.0), next(n, 0.0);
  accelerations.find(force, shape);
  for (int degree = 1; degree <= 20; ++degree) {
    op.apply(shape.data(), force.data());
    accelerations.find(force, next);
    const double factor = degree == 1 ? 1 : 2;
    for (std::size_t i = 0; i < n; ++i) next[i] = factor * (next[i] / middle - shape[i]) - before[i];
    before.swap(shape);
    shape.swap(next);
  }
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(shape.begin(), shape.end(), smaller) - shape.begin());
}

// Every dashpot as a spring of `stiffness` [N/m] for each N s/m.
forces::ForceElements dashpotsAsSprings(const model::Model& model, double stiffness) {
  forces::ForceElements springs;
  for (const auto& set : model.forceElements)
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set.damping[i] > 0) springs.add(set.terms(i), stiffness * set.damping[i], 0);
  return springs;
}

// Beta [s]. A share of critical counts at the highest frequency of the mesh as it is: more inertia for short waves is
// to change nothing else, and by lowering that frequency it would raise the damping of all others.
double dampingOf(const model::Model& model, model::StaticOperator& op, const Highest& highest, Monitor& monitor,
                 int& iterations) {
  const auto& damping = model.scenario.damping;
  if (damping.beta > 0) return damping.beta;
  const bool isSlowed = std::any_of(model.blocks.begin(), model.blocks.end(),
                                    [](const auto& block) { return !block.inertia.clusters.empty(); });
  double eigenvalue = highest.value;
  if (isSlowed && damping.fraction > 0) {
    const Highest bare = highestEigenvalue(op, Accelerations(model, op, ShortWaves::asTheyAre), monitor);
    eigenvalue = bare.value, iterations += bare.iterations;
  }
  return 2 * damping.fraction / std::sqrt(eigenvalue);
}

std::string locationOf(const model::Model& model, std::size_t unknown) {
  return model::partName(model, unknown) + "; " + model::locationName(model, unknown);
}

}  // namespace

StableStep stableStep(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                      Monitor& monitor) {
  model::StaticOperator op(model, kernels, team, 0, 0, false);
  op.stiffen();
  const Accelerations accelerations(model, op, ShortWaves::slowed);
  Highest highest = highestEigenvalue(op, accelerations, monitor);
  StableStep result;
  result.iterations = highest.iterations;
  result.highestFrequency = std::sqrt(highest.value);
  result.beta = dampingOf(model, op, highest, monitor, result.iterations);
  // dt^2 + 2 beta dt = 4 / w^2.
  const auto stepFor = [&](double eigenvalue) {
    const double root = std::sqrt(eigenvalue), z = 0.5 * result.beta * root;
    return 2 / root * (std::sqrt(1 + z * z) - z);
  };
  double bound = stepFor(highest.value);
  const char* by = "";

  // Dashpots act on the velocity of the half step before: 4 M - (dt^2 + 2 beta dt) K - 2 dt C must be positive
  // definite, as if they were springs of 2 C / (dt + 2 beta). The bound falls to its limit from above, half way (in its
  // logarithm) each time; where they do not bind, it stays as it was.
  for (int k = 0; k < 20 && !monitor.cancelled(); ++k) {
    op.contactSprings() = dashpotsAsSprings(model, 2 / (bound + 2 * result.beta));
    if (op.contactSprings().size() == 0) break;
    highest = highestEigenvalue(op, accelerations, monitor);
    result.iterations += highest.iterations;
    const double shorter = stepFor(highest.value);
    if (shorter > bound * (1 - 1e-3)) break;
    bound = shorter;
    by = ", by its dampers";
  }
  if (!monitor.cancelled()) result.location = locationOf(model, whereHighest(op, accelerations, highest.value)) + by;
  if (const double byContact = stepFor(eigenvalueOfStiffContact(model.scenario)); byContact < bound) {
    bound = byContact;
    result.location = "the contact, by its penalties";
  }
  result.step = safety * bound;
  return result;
}

}  // namespace squat::dynamics
