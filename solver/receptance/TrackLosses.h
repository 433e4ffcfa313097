// solver/receptance/TrackLosses.h - complex stiffness of rail, sleepers, pads and ballast in the frequency domain.
//
// A loss factor eta makes a stiffness k (1 + i eta) at every frequency; measured pads have k(f) of their own
// (scenario/Track.h). Neither has a counterpart in a rolling run, which has dashpots only
// (scenario/ComplexStiffness.h).
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
// its dashpots count. The scenario must outlive the functions.
std::array<ComplexFactor, trackParts> trackLosses(const scenario::Scenario& scenario);

// Loss factors and measured pads of the case, which a rolling run does not use, each with the spring and dashpot that
// come nearest from 100 to 2000 Hz and with what the case has in their place. Empty where there are none.
std::vector<std::string> lossNotes(const scenario::Scenario& scenario);

}  // namespace squat::receptance
