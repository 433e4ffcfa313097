#include "calibration/StatementResiduals.h"

#include <algorithm>
#include <cmath>

#include "statements/Judge.h"

namespace squat::calibration {

double statementResidual(const statements::Statement& s, double value) {
  constexpr double margin = 0.25;
  const bool hasLow = std::isfinite(s.low), hasHigh = std::isfinite(s.high);
  if (hasLow && hasHigh) {
    const double middle = s.expected ? std::clamp(*s.expected, s.low, s.high) : 0.5 * (s.low + s.high);
    const double half = value < middle ? middle - s.low : s.high - middle;
    if (half > 0) return (value - middle) / half;
    if (value == middle) return 0;  // expected at a limit: beyond it the statement is broken
    return (value < middle ? -1 : 1) + (value - middle) / (0.5 * (s.high - s.low));
  }
  const double limit = hasLow ? s.low : s.high;
  const double inside = hasLow ? value - limit : limit - value;
  const double scale = margin * std::max(std::abs(limit), 1e-12);
  return std::max(0.0, 1 - inside / scale) * (hasLow ? -1 : 1);
}

std::vector<TargetValue> statementValues(const Targets& targets,
                                         const std::map<std::string, results::RunResult>& results,
                                         const std::string& mesh) {
  statements::Reference reference;
  reference.runs = targets.runs;
  for (const auto& target : targets.statements) reference.statements.push_back(target.statement);
  std::vector<TargetValue> values;
  for (const auto& judged : statements::judge(reference, results, mesh)) {
    TargetValue value;
    value.value = judged.value;
    value.isMet = judged.verdict == statements::Verdict::met;
    const double residual = judged.value ? std::clamp(statementResidual(judged.statement, *judged.value),
                                                      -kMissingResidual, kMissingResidual)
                                         : kMissingResidual;
    // Outside the range steeper than inside: a limit that is broken weighs more than a margin that is gained.
    const double outside = std::max(0.0, std::abs(residual) - 1);
    value.misfit = residual * residual + 4 * outside * (1 + outside);
    value.residuals = {residual};
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace squat::calibration
