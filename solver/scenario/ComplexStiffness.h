// solver/scenario/ComplexStiffness.h - stiffness with losses, as the frequency domain has it, and the spring and
// dashpot that come nearest: a rolling run has no others.
#pragma once

#include <complex>
#include <functional>

#include "scenario/Track.h"

namespace squat::scenario {

// Of the table at a frequency [Hz], linear in the logarithm of the frequency; beyond its ends as at the nearest row.
// Throws nothing; the table has a row.
std::complex<double> tabulatedStiffness(const std::vector<DynamicStiffness>& table, double frequency,
                                        std::complex<double> DynamicStiffness::*member);

// Vertical stiffness of a whole pad [N/m] at a frequency [Hz]: of its table, else stiffness times 1 + i lossFactor.
std::complex<double> padStiffness(const Pad& pad, double frequency);

// k + i w c nearest to the complex stiffness in the mean square of the ratio, over frequencies in equal ratios.
struct ViscousEquivalent {
  double stiffness = 0, damping = 0;  // [N/m], [N s/m]
  double misfit = 0;                  // [-] root mean square of the difference over the complex stiffness
};
ViscousEquivalent viscousEquivalent(const std::function<std::complex<double>(double frequency)>& stiffness,
                                    double lowest, double highest);

// The frequencies [Hz] over which equivalents are shown.
inline constexpr double kEquivalentFrom = 100, kEquivalentTo = 2000;

}  // namespace squat::scenario
