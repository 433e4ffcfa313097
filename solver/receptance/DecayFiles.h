// solver/receptance/DecayFiles.h - decay rates as a table, and those that others measured.
#pragma once

#include <string>
#include <vector>

#include "receptance/DecayRate.h"

namespace squat::receptance {

// What was measured in one third octave and direction; all zero where nothing was.
struct MeasuredDecay {
  int count = 0;
  double lowest = 0, mean = 0, highest = 0;  // [dB/m]
  bool holds(double rate) const { return count > 0 && rate >= lowest && rate <= highest; }
};

struct MeasuredDecayRates {
  std::vector<double> band;  // [Hz]
  std::vector<MeasuredDecay> vertical, lateral;
  MeasuredDecay at(double band, RailDirection direction) const;
};

// One row a measurement: a column "direction" (vertical, v; lateral, horizontal, l, h) and one a third octave, "100 Hz
// [dB/m]"; or one row a third octave: frequency [Hz], vertical [dB/m], lateral [dB/m], other columns left out. Nominal
// and exact middles of third octaves from 50 to 5000 Hz. Empty fields and "nan" are left out. Throws FileError.
MeasuredDecayRates readMeasuredDecayRates(const std::string& path);

// frequency [Hz], vertical, lateral [dB/m], lower limits of ISO 3095; with measurements, their range.
std::string decayCsv(const DecayRates& rates, const MeasuredDecayRates* measured = nullptr);

// The same for a terminal, with how many third octaves lie within what was measured.
std::string decaySummary(const DecayRates& rates, const MeasuredDecayRates* measured = nullptr);

}  // namespace squat::receptance
