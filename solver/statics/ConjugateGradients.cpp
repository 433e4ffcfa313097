#include "statics/ConjugateGradients.h"

#include <cmath>

#include "core/OrderedSum.h"

namespace squat::statics {

namespace {

// Sums of r.r and r.D^-1 r.
struct Norms {
  double residual2 = 0, weighted = 0;
  Norms& operator+=(const Norms& other) {
    residual2 += other.residual2, weighted += other.weighted;
    return *this;
  }
};

}  // namespace

LinearSolution conjugateGradients(StaticSystem& system, const AlignedVector& b, AlignedVector& x, double target,
                                  int maximumIterations, const std::function<bool(int, double)>& step) {
  auto& team = system.team();
  const std::size_t n = b.size();
  const AlignedVector inverse = system.inverseDiagonal();
  AlignedVector r = b, p(n, 0.0), q(n, 0.0);
  std::fill(x.begin(), x.end(), 0.0);

  LinearSolution solution;
  double rz = 0, alpha = 0;
  while (true) {
    // Everything that needs the new residual in one pass: vectors outgrow the caches, and moving them costs as much as
    // the operator.
    const auto norms = orderedSum(team, n, Norms{}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) r[i] -= alpha * q[i];
      return Norms{sumInLanes(begin, end, [&](std::size_t i) { return r[i] * r[i]; }),
                   sumInLanes(begin, end, [&](std::size_t i) { return r[i] * inverse[i] * r[i]; })};
    });
    solution.residual = std::sqrt(norms.residual2);
    const auto correction = system.correctionOf(r.data());
    if (solution.residual < target || solution.iterations >= maximumIterations) {
      for (std::size_t i = 0; i < n; ++i) x[i] += alpha * p[i];
      // A last coarse correction leaves no resultant force on any coarse field, rigid motions of the wheelset among
      // them.
      system.prolong(correction.y, x.data());
      return solution;
    }
    if (solution.iterations % 8 == 0 && !step(solution.iterations, solution.residual)) {
      solution.cancelled = true;
      return solution;
    }
    // z = D^-1 r + Z y is never stored: r.z is known, and p takes it as it comes. The solution takes the last p when
    // that is read anyway.
    const double next = norms.weighted + correction.product, beta = rz > 0 ? next / rz : 0;
    rz = next;
    orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) x[i] += alpha * p[i], p[i] = inverse[i] * r[i] + beta * p[i];
      return 0.0;
    });
    system.prolong(correction.y, p.data());
    system.apply(p.data(), q.data());
    const double curvature = orderedSum(team, n, [&](std::size_t begin, std::size_t end) {
      return sumInLanes(begin, end, [&](std::size_t i) { return p[i] * q[i]; });
    });
    alpha = rz / curvature;
    ++solution.iterations;
  }
}

}  // namespace squat::statics
