#include "supports/Springs.h"

namespace squat::supports {

void SpringSet::add(const std::vector<std::pair<std::size_t, double>>& terms, double k, double c) {
  for (const auto& [index, share] : terms) {
    unknown.push_back(index);
    weight.push_back(share);
  }
  start.push_back(unknown.size());
  stiffness.push_back(k);
  damping.push_back(c);
}

void addSpringStiffness(const SpringSet& set, const double* u, double* result) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    double q = 0;
    for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t) q += set.weight[t] * u[set.unknown[t]];
    q *= set.stiffness[i];
    for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t) result[set.unknown[t]] += set.weight[t] * q;
  }
}

void addSpringDiagonal(const SpringSet& set, double* diagonal) {
  for (std::size_t i = 0; i < set.size(); ++i)
    for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t)
      diagonal[set.unknown[t]] += set.stiffness[i] * set.weight[t] * set.weight[t];
}

SpringPower springPower(const SpringSet& set, const double* displacement, const double* velocity) {
  SpringPower power;
  for (std::size_t i = 0; i < set.size(); ++i) {
    double q = 0, rate = 0;
    for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t) {
      q += set.weight[t] * displacement[set.unknown[t]];
      rate += set.weight[t] * velocity[set.unknown[t]];
    }
    power.stored += 0.5 * set.stiffness[i] * q * q;
    power.dissipation += set.damping[i] * rate * rate;
  }
  return power;
}

}  // namespace squat::supports
