// solver/validation/Measures.h - numbers that statements are judged by, each from the result of one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/RunResult.h"
#include "validation/Reference.h"

namespace squat::validation {

// Names that a statement may use:
//   maximum         [m/s2] largest filtered ABA               elements        number of the mesh
//   wavelength      [mm] mean after the impact, by the ridge  wave_frequency  [Hz] speed over wavelength
//   line            [Hz] the strong line (5 % of the highest's prominence) nearest to `near`, by ratio
//   lines_within    number of peaks (1 %) in the band         band_power      [(m/s2)2] integral over the band
//   band_share      of the integral of the whole spectrum     free_vibration  [ms] in the band, after the impact
//   impact_top      [Hz] highest frequency within 10 mm of the impact with 5 % of the scalogram's largest power
//   quiet           [m/s2] largest deviation from the mean over 0.2 m before the defect (-0.24 to -0.04 m)
std::vector<std::string> measureNames();

// No value where the result does not hold what is needed (too short, no impact).
std::optional<double> measure(const results::RunResult& result, const Statement& statement);

}  // namespace squat::validation
