#include "scenario/ComplexStiffness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace squat::scenario {

using Complex = std::complex<double>;

Complex tabulatedStiffness(const std::vector<DynamicStiffness>& table, double frequency,
                           Complex DynamicStiffness::*member) {
  const auto next = std::lower_bound(table.begin(), table.end(), frequency,
                                     [](const auto& row, double f) { return row.frequency < f; });
  if (next == table.begin()) return table.front().*member;
  if (next == table.end()) return table.back().*member;
  const auto before = next - 1;
  const double share = std::log(frequency / before->frequency) / std::log(next->frequency / before->frequency);
  return (1 - share) * ((*before).*member) + share * ((*next).*member);
}

Complex padStiffness(const Pad& pad, double frequency) {
  if (pad.dynamic.empty()) return pad.stiffness * Complex(1, pad.lossFactor);
  return tabulatedStiffness(pad.dynamic, frequency, &DynamicStiffness::vertical);
}

// Minimises the sum of |k + i w c - K|^2 / |K|^2: real and imaginary part fall apart.
ViscousEquivalent viscousEquivalent(const std::function<Complex(double frequency)>& stiffness, double lowest,
                                    double highest) {
  constexpr int steps = 60;
  double one = 0, real = 0, square = 0, imaginary = 0;
  const auto frequencyAt = [&](int i) { return lowest * std::pow(highest / lowest, static_cast<double>(i) / steps); };
  for (int i = 0; i <= steps; ++i) {
    const double omega = 2 * std::numbers::pi * frequencyAt(i);
    const Complex k = stiffness(frequencyAt(i));
    const double weight = 1 / std::norm(k);
    one += weight, real += weight * k.real();
    square += weight * omega * omega, imaginary += weight * omega * k.imag();
  }
  ViscousEquivalent found{real / one, imaginary / square, 0};
  for (int i = 0; i <= steps; ++i) {
    const Complex k = stiffness(frequencyAt(i));
    const Complex near(found.stiffness, 2 * std::numbers::pi * frequencyAt(i) * found.damping);
    found.misfit += std::norm(near - k) / std::norm(k) / (steps + 1);
  }
  found.misfit = std::sqrt(found.misfit);
  return found;
}

}  // namespace squat::scenario
