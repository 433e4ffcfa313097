// solver/receptance/TrackLosses.h - complex stiffness of rail, sleepers, pads and ballast in the frequency domain.
//
// A loss factor eta makes a stiffness k (1 + i eta) at every frequency; measured pads have k(f) of their own
// (scenario/Track.h). Neither has a counterpart in the time domain, which knows dashpots only: viscousEquivalent() says
// which come nearest.
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "receptance/TrackSystem.h"

namespace squat::receptance {

using ComplexFactor = std::function<std::complex<double>(double omega)>;

// Per part, what its stiffness is multiplied with at an angular frequency [rad/s], dashpots included; empty: 1, and
// its dashpots count.
std::array<ComplexFactor, trackParts> trackLosses(const scenario::Scenario& scenario);

// Vertical stiffness of a whole pad [N/m] at a frequency [Hz], as trackLosses() takes it.
std::complex<double> padStiffness(const scenario::Pad& pad, double frequency);

// k + i w c nearest to the complex stiffness in the mean square of the ratio, over frequencies in equal ratios.
struct ViscousEquivalent {
  double stiffness = 0, damping = 0;  // [N/m], [N s/m]
  double misfit = 0;                  // root mean square of the difference over the complex stiffness
};
ViscousEquivalent viscousEquivalent(const std::function<std::complex<double>(double frequency)>& stiffness,
                                    double lowest, double highest);

// What the case says by loss factors or measured pads and the rolling run cannot do, with the dashpots that come
// nearest from 100 to 2000 Hz and what the case has in their place. Empty where there is none of it.
std::vector<std::string> lossNotes(const scenario::Scenario& scenario);

}  // namespace squat::receptance
