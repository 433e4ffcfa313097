// solver/statics/ConjugateGradients.h - conjugate gradients, preconditioned by diagonal and coarse space.
#pragma once

#include <functional>

#include "statics/StaticSystem.h"

namespace squat::statics {

struct LinearSolution {
  int iterations = 0;
  double residual = 0;  // 2-norm at the end
  bool cancelled = false;
};

// Solves (K + contact) x = b from x = 0 until the residual's 2-norm is below `target` or `maximumIterations` are done.
// `step(iterations, residual)` is asked every few iterations and returns false to stop; x is not to be used then.
LinearSolution conjugateGradients(StaticSystem& system, const AlignedVector& b, AlignedVector& x, double target,
                                  int maximumIterations, const std::function<bool(int, double)>& step);

}  // namespace squat::statics
