#include "calibration/LocalSearch.h"

#include <nlopt.h>

#include <algorithm>
#include <memory>

namespace squat::calibration {

namespace {

struct Call {
  const Misfit* misfit;
  nlopt_opt search;
};

double evaluate(unsigned n, const double* x, double*, void* data) {
  auto& call = *static_cast<Call*>(data);
  const auto value = (*call.misfit)(UnitPoint(x, x + n));
  if (!value) nlopt_force_stop(call.search);
  return value.value_or(0);
}

}  // namespace

void searchFrom(const UnitPoint& start, const Misfit& misfit, const LocalSearchOptions& options) {
  const auto n = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(
      nlopt_create(n > 1 ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD, n), nlopt_destroy);
  Call call{&misfit, search.get()};
  nlopt_set_min_objective(search.get(), evaluate, &call);
  nlopt_set_lower_bounds1(search.get(), 0);
  nlopt_set_upper_bounds1(search.get(), 1);
  nlopt_set_initial_step1(search.get(), options.firstStep);
  nlopt_set_xtol_abs1(search.get(), options.lastStep);
  nlopt_set_maxeval(search.get(), options.evaluations);
  UnitPoint x = start;
  for (double& coordinate : x) coordinate = std::clamp(coordinate, 0.0, 1.0);
  double value = 0;
  // Whatever ends it (budget, tolerance, rounding), the caller has seen every point.
  nlopt_optimize(search.get(), x.data(), &value);
}

}  // namespace squat::calibration
