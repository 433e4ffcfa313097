// widgets/plots/ReceptanceFigures.h - receptance of the track and modes of the wheelset.
#pragma once

#include <string>

#include "plots/FigureSheet.h"
#include "receptance/Receptance.h"

namespace squat::plots {

// Sheet `name`: magnitude and phase over frequency, and the shares of the wheelset's modes at axle box, wheel
// centre and contact.
FigureSheet receptanceFigures(const receptance::TrackReceptance& receptance, const std::string& name,
                              const std::string& title, const std::string& hash, const Style& style,
                              receptance::ReceptanceQuantity quantity = receptance::ReceptanceQuantity::receptance);

}  // namespace squat::plots
