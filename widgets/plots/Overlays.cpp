#include "plots/Overlays.h"

namespace squat::plots {

double passageTime(const signals::Record& result) {
  if (result.time.empty() || result.position.empty() || !(result.speed > 0)) return 0;
  return result.time.front() - result.position.front() / result.speed;
}

Curve againstPosition(const signals::Record& other, const std::string& signal, double factor) {
  const auto* values = other.signal(signal);
  if (!values) return {};
  return {scaled(other.position, 1e3), scaled(*values, factor), {}};
}

Curve againstTime(const signals::Record& other, const signals::Record& shown, const std::string& signal,
                  double factor) {
  Curve curve = againstPosition(other, signal, factor);
  if (curve.y.empty()) return {};
  const double shift = passageTime(shown) - passageTime(other);
  curve.x = other.time;
  for (double& time : curve.x) time = 1e3 * (time + shift);
  return curve;
}

}  // namespace squat::plots
