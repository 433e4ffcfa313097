// tests/verification/ReceptanceComparison.h - receptance of the solid track beside that of a Timoshenko beam.
#pragma once

#include "case/CaseDescription.h"
#include "model/Model.h"
#include "receptance/Receptance.h"
#include "verification/TrackBeam.h"

namespace squat::verification {

constexpr double kShift = 0.04, kDecibels = 1.5, kDegrees = 8;

// How far `expected` [dB] lies outside the solid's levels within 4 % of a frequency.
double levelDifference(const receptance::TrackReceptance& solid, const std::vector<std::complex<double>>& values,
                       double frequency, double expected);

// The beam that stands for the track of a solid model.
TrackBeam beamOf(const model::Model& model);

// Without the wheelset's modes, one thread.
receptance::TrackReceptance solidTrack(const cases::CaseDescription& description,
                                       receptance::ReceptanceOptions options = {});

// Expects levels and resonances of both points to be those of the beam, looked at every `step` [Hz].
void compareWithBeam(const cases::CaseDescription& description, double step,
                     const receptance::ReceptanceOptions& options = {});

}  // namespace squat::verification
