// solver/statements/Measures.h - numbers that statements are judged by, each from the result of one run, at the
// statement's point of the vehicle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/RunResult.h"
#include "statements/Reference.h"

namespace squat::statements {

// Names that a statement may use:
//   maximum         [m/s2] largest filtered acceleration      elements        number of the mesh
//   wavelength      [mm] mean after the impact, by the ridge  wave_frequency  [Hz] speed over wavelength
//   line            [Hz] the strong line (5 % of the highest's prominence) nearest to `near`, by ratio; the judge gives
//                   a line to one statement only
//   lines_within    number of peaks (1 %) in the band         band_power      [(m/s2)2] integral over the band
//   band_share      of the integral of the whole spectrum
//   free_vibration  how many times longer the band rings after the impact than its filter after a kick; 1: a kick; 0:
//                   what rings as long is a stronger line beside the band
//   impact_top      [Hz] highest frequency with 5 % of the scalogram's largest power, within 10 mm of the deepest point
//                   of the defect
//   residual_vibration [m/s2] residualVibration() of RunChecks.h; "quiet" until 0.2
// Spectra reach from 0.1 m before the impact to 0.28 m behind it; those for lines or bands at or below 320 Hz, a period
// of which takes 0.1 m, to 0.58 m where the run goes that far.
std::vector<std::string> measureNames();

// The unit in which a measure is given and judged: "m/s2", "mm", "Hz"; "1" for a pure number.
std::string unitOfMeasure(const std::string& name);

// No value where the result does not hold what is needed (too short, no impact).
std::optional<double> measure(const results::RunResult& result, const Statement& statement);

// What "line" chooses from, and how near two frequencies may be before the spectrum's window cannot part them [Hz].
struct Lines {
  std::vector<double> frequencies;  // most prominent first
  double resolution = 0;
};
// Nothing where the record is too short. A statement that names no line takes the window of the impact.
std::optional<Lines> strongLines(const results::RunResult& result, const Statement& statement);

}  // namespace squat::statements
