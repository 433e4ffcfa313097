#include "statics/ConjugateGradients.h"

#include <cmath>

#include "core/OrderedSum.h"

namespace squat::statics {

LinearSolution conjugateGradients(model::StaticOperator& op, const CoarseSpace& coarse, const AlignedVector& b,
                                  AlignedVector& x, double target, int mostIterations,
                                  const std::function<bool(int, double)>& step) {
  auto& team = op.team();
  const std::size_t n = b.size();
  const auto& free = op.freeUnknowns();
  AlignedVector inverse = op.diagonal();
  for (std::size_t i = 0; i < n; ++i) inverse[i] = free[i] ? 1 / inverse[i] : 0;
  AlignedVector r = b, z(n, 0.0), p(n, 0.0), q(n, 0.0);
  std::fill(x.begin(), x.end(), 0.0);

  LinearSolution solution;
  double rz = 0;
  while (true) {
    // z = (diagonal + coarse) r; the sums for the norm and r.z are taken on the way.
    double norm2 = orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) z[i] = inverse[i] * r[i], sum += r[i] * r[i];
      return sum;
    });
    solution.residual = std::sqrt(norm2);
    if (solution.residual < target || solution.iterations >= mostIterations) {
      // A last coarse correction leaves no resultant force on any coarse field, rigid motions of the wheelset among
      // them.
      coarse.addCorrection(team, r.data(), x.data());
      return solution;
    }
    if (solution.iterations % 8 == 0 && !step(solution.iterations, solution.residual)) {
      solution.cancelled = true;
      return solution;
    }
    coarse.addCorrection(team, r.data(), z.data());
    const double next = orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += r[i] * z[i];
      return sum;
    });
    const double beta = rz > 0 ? next / rz : 0;
    rz = next;
    orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) p[i] = z[i] + beta * p[i];
      return 0.0;
    });
    op.apply(p.data(), q.data());
    const double curvature = orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += p[i] * q[i];
      return sum;
    });
    const double alpha = rz / curvature;
    orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) x[i] += alpha * p[i], r[i] -= alpha * q[i];
      return 0.0;
    });
    ++solution.iterations;
  }
}

}  // namespace squat::statics
