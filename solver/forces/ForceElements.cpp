#include "forces/ForceElements.h"

namespace squat::forces {

void ForceElements::add(const std::vector<std::pair<std::size_t, double>>& terms, double k, double c) {
  for (const auto& [index, share] : terms) {
    unknown.push_back(index);
    weight.push_back(share);
  }
  start.push_back(unknown.size());
  stiffness.push_back(k);
  damping.push_back(c);
}

std::vector<std::pair<std::size_t, double>> ForceElements::terms(std::size_t element) const {
  std::vector<std::pair<std::size_t, double>> list;
  for (std::size_t t = start[element]; t < start[element + 1]; ++t) list.emplace_back(unknown[t], weight[t]);
  return list;
}

void addStiffness(const ForceElements& linear, const double* u, double* result) {
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const double force = linear.stiffness[i] * linear.elongation(i, u);
    for (std::size_t t = linear.start[i]; t < linear.start[i + 1]; ++t)
      result[linear.unknown[t]] += linear.weight[t] * force;
  }
}

void addDiagonal(const ForceElements& linear, double* diagonal) {
  for (std::size_t i = 0; i < linear.size(); ++i)
    for (std::size_t t = linear.start[i]; t < linear.start[i + 1]; ++t)
      diagonal[linear.unknown[t]] += linear.stiffness[i] * linear.weight[t] * linear.weight[t];
}

double storedEnergy(const ForceElements& set, const double* displacement) {
  double sum = 0;
  for (std::size_t i = 0; i < set.size(); ++i) sum += set.storedEnergy(i, set.elongation(i, displacement));
  return sum;
}

}  // namespace squat::forces
