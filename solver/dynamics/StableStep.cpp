#include "dynamics/StableStep.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>
#include <vector>

#include "core/OrderedSum.h"
#include "model/StaticOperator.h"

namespace squat::dynamics {

namespace {

constexpr double safety = 0.95;  // Lanczos values approach from below

// Square root of the inverse mass of every free unknown of the solids, zero elsewhere: it scales to the symmetric
// problem A = M^-1/2 K M^-1/2.
AlignedVector rootOfInverseMass(const model::Model& model, const std::vector<unsigned char>& free) {
  AlignedVector root(model.stateSize, 0.0);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    for (int node = 0; node < block.nodes; ++node)
      for (int c = 0; c < 3; ++c)
        for (int s = 0; s < block.stationCount; ++s) {
          const std::size_t i = block.index(node, c, s);
          if (free[i]) root[i] = std::sqrt(model.inverseMass[b][node * block.stride + s]);
        }
  }
  return root;
}

AlignedVector startVector(const AlignedVector& rootInverse) {
  AlignedVector vector(rootInverse.size(), 0.0);
  unsigned long seed = 88172645463325252UL;
  double norm2 = 0;
  for (std::size_t i = 0; i < vector.size(); ++i) {
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    vector[i] = rootInverse[i] > 0 ? static_cast<double>(seed >> 11) / 9007199254740992.0 - 0.5 : 0.0;
    norm2 += vector[i] * vector[i];
  }
  for (double& value : vector) value /= std::sqrt(norm2);
  return vector;
}

double largestOf(const std::vector<double>& diagonal, const std::vector<double>& side) {
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(Vector(diagonal.data(), static_cast<Eigen::Index>(diagonal.size())),
                               Vector(side.data(), static_cast<Eigen::Index>(side.size())), Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().maxCoeff();
}

struct Highest {
  double value = 0;       // [rad2/s2] of M^-1 K
  std::size_t place = 0;  // unknown that moves most in about its mode
  int iterations = 0;
};

Highest highestEigenvalue(model::StaticOperator& op, const AlignedVector& rootInverse, Monitor& monitor) {
  ThreadTeam& team = op.team();
  const std::size_t n = rootInverse.size();
  AlignedVector previous(n, 0.0), now = startVector(rootInverse), scaled(n, 0.0), next(n, 0.0);
  Highest highest;
  std::vector<double> alpha, beta;
  for (int k = 0; k < 400; ++k) {
    for (std::size_t i = 0; i < n; ++i) scaled[i] = rootInverse[i] * now[i];
    op.apply(scaled.data(), next.data());
    const double a = orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) next[i] *= rootInverse[i], sum += next[i] * now[i];
      return sum;
    });
    const double last = beta.empty() ? 0 : beta.back();
    const double b2 = orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) next[i] -= a * now[i] + last * previous[i], sum += next[i] * next[i];
      return sum;
    });
    alpha.push_back(a);
    const double b = std::sqrt(b2);
    highest.iterations = k + 1;
    if (k % 10 == 9 || b < 1e-12 * a) {
      const double before = std::exchange(highest.value, largestOf(alpha, beta));
      Progress progress;
      progress.phase = "stable step", progress.fraction = std::min(1.0, k / 100.0);
      monitor.report(progress);
      if (std::abs(highest.value - before) < 1e-4 * highest.value || monitor.cancelled() || b < 1e-12 * a) break;
    }
    beta.push_back(b);
    for (std::size_t i = 0; i < n; ++i) previous[i] = now[i], now[i] = next[i] / b;
  }
  // The last Lanczos vector is rich in the highest modes: its largest entry shows about where they sit.
  for (std::size_t i = 0; i < n; ++i)
    if (std::abs(now[i]) * rootInverse[i] > std::abs(now[highest.place]) * rootInverse[highest.place])
      highest.place = i;
  return highest;
}

// Every dashpot as a spring of `stiffness` [N/m] for each N s/m.
supports::SpringSet dashpotsAsSprings(const model::Model& model, const model::StaticOperator& op, double stiffness) {
  supports::SpringSet springs;
  for (const auto* set : {&model.pads, &model.ballast, &model.ends, &op.vehicleSprings()})
    for (std::size_t i = 0; i < set->size(); ++i) {
      if (set->damping[i] <= 0) continue;
      std::vector<std::pair<std::size_t, double>> terms;
      for (std::size_t t = set->start[i]; t < set->start[i + 1]; ++t)
        terms.emplace_back(set->unknown[t], set->weight[t]);
      springs.add(terms, stiffness * set->damping[i], 0);
    }
  return springs;
}

}  // namespace

StableStep stableStep(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                      Monitor& monitor) {
  model::StaticOperator op(model, kernels, team, 0, 0, false);
  const AlignedVector rootInverse = rootOfInverseMass(model, op.freeUnknowns());
  Highest highest = highestEigenvalue(op, rootInverse, monitor);
  StableStep result;
  result.iterations = highest.iterations;
  result.highestFrequency = std::sqrt(highest.value);
  const auto& damping = model.description.damping;
  result.beta = damping.beta > 0 ? damping.beta : 2 * damping.fraction / result.highestFrequency;
  // dt^2 + 2 beta dt = 4 / w^2.
  const auto stepFor = [&](double eigenvalue) {
    const double root = std::sqrt(eigenvalue), z = 0.5 * result.beta * root;
    return 2 / root * (std::sqrt(1 + z * z) - z);
  };
  double bound = stepFor(highest.value);
  result.place = model::placeName(model, highest.place);

  // Dashpots act on the velocity of the half step before: 4 M - (dt^2 + 2 beta dt) K - 2 dt C must be positive
  // definite, as if they were springs of 2 C / (dt + 2 beta). The bound falls to its limit from above, half way (in its
  // logarithm) each time; where they do not bind, it stays as it was.
  for (int k = 0; k < 20 && !monitor.cancelled(); ++k) {
    op.contactSprings() = dashpotsAsSprings(model, op, 2 / (bound + 2 * result.beta));
    if (op.contactSprings().size() == 0) break;
    highest = highestEigenvalue(op, rootInverse, monitor);
    result.iterations += highest.iterations;
    const double shorter = stepFor(highest.value);
    if (shorter > bound * (1 - 1e-3)) break;
    bound = shorter;
    result.place = model::placeName(model, highest.place) + ", by its dampers";
  }
  result.step = safety * bound;
  return result;
}

}  // namespace squat::dynamics
