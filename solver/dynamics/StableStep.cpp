#include "dynamics/StableStep.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/OrderedSum.h"
#include "model/StaticOperator.h"

namespace squat::dynamics {

StableStep stableStep(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                      Monitor& monitor) {
  model::StaticOperator op(model, kernels, team, 0, 0, false);
  const std::size_t n = model.stateSize;
  const auto& free = op.freeUnknowns();
  // Square root of the mass scales to a symmetric problem: A = M^-1/2 K M^-1/2.
  AlignedVector rootInverse(n, 0.0);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    for (int node = 0; node < block.nodes; ++node)
      for (int c = 0; c < 3; ++c)
        for (int s = 0; s < block.stationCount; ++s) {
          const std::size_t i = block.index(node, c, s);
          if (free[i]) rootInverse[i] = std::sqrt(model.inverseMass[b][node * block.stride + s]);
        }
  }
  AlignedVector previous(n, 0.0), now(n, 0.0), scaled(n, 0.0), next(n, 0.0);
  unsigned long seed = 88172645463325252UL;
  double norm2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    now[i] = rootInverse[i] > 0 ? static_cast<double>(seed >> 11) / 9007199254740992.0 - 0.5 : 0.0;
    norm2 += now[i] * now[i];
  }
  for (double& value : now) value /= std::sqrt(norm2);

  StableStep result;
  std::vector<double> alpha, beta;
  double largest = 0;
  AlignedVector direction = now;
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
    result.iterations = k + 1;
    if (k % 10 == 9 || b < 1e-12 * a) {
      Eigen::VectorXd diagonal = Eigen::Map<Eigen::VectorXd>(alpha.data(), static_cast<Eigen::Index>(alpha.size()));
      Eigen::VectorXd side = Eigen::Map<Eigen::VectorXd>(beta.data(), static_cast<Eigen::Index>(beta.size()));
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
      eigen.computeFromTridiagonal(diagonal, side, Eigen::EigenvaluesOnly);
      const double before = std::exchange(largest, eigen.eigenvalues().maxCoeff());
      Progress progress;
      progress.phase = "stable step", progress.fraction = std::min(1.0, k / 100.0);
      monitor.report(progress);
      if (std::abs(largest - before) < 1e-4 * largest || monitor.cancelled() || b < 1e-12 * a) break;
    }
    beta.push_back(b);
    for (std::size_t i = 0; i < n; ++i) previous[i] = now[i], now[i] = next[i] / b;
  }
  // The last Lanczos vector is rich in the highest modes: its largest entry shows about where they sit.
  std::size_t at = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (std::abs(now[i]) * rootInverse[i] > std::abs(now[at]) * rootInverse[at]) at = i;
  result.place = model::placeName(model, at);
  result.highestFrequency = std::sqrt(largest);
  const auto& damping = model.description.damping;
  result.beta = damping.beta > 0 ? damping.beta : 2 * damping.fraction / result.highestFrequency;
  const double z = 0.5 * result.beta * result.highestFrequency;
  result.step = 0.95 * 2 / result.highestFrequency * (std::sqrt(1 + z * z) - z);
  return result;
}

}  // namespace squat::dynamics
