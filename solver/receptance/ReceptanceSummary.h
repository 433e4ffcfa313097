// solver/receptance/ReceptanceSummary.h - receptance and modes as text, for a terminal and for the studio.
#pragma once

#include <string>
#include <vector>

#include "receptance/Receptance.h"

namespace squat::receptance {

// Receptance at a few frequencies, resonances, natural modes and notes; every line ends with a line break.
std::string receptanceSummary(const TrackReceptance& receptance,
                              ReceptanceQuantity quantity = ReceptanceQuantity::receptance);

// Natural modes of the wheelset: frequency, mass-normalised mode shape at axle box, wheel centre, contact.
std::string modesTable(const std::vector<model::HarmonicMode>& modes);

}  // namespace squat::receptance
