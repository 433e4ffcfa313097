// widgets/plots/DecayFigures.h - track decay rates beside the limits of ISO 3095 and what was measured.
#pragma once

#include <string>

#include "plots/FigureSheet.h"
#include "receptance/DecayFiles.h"

namespace squat::plots {

// Sheet `name`: vertical and lateral decay rates over third octaves on logarithmic axes, 0.1 to 100 dB/m (EN 15461, 9.2
// begins at 0.01), the lower limits of ISO 3095, and the mean and range of measurements where there are any.
FigureSheet decayFigures(const receptance::DecayRates& rates, const receptance::MeasuredDecayRates* measured,
                         const std::string& name, const std::string& title, const std::string& hash,
                         const Style& style);

}  // namespace squat::plots
