// solver/receptance/ThirdOctaves.h - third octaves of frequency: middles 1000 * 10^(n/10) Hz, named by their rounded
// values (IEC 61260).
#pragma once

#include <complex>
#include <optional>
#include <vector>

namespace squat::receptance {

// Nominal middles [Hz] from 50 to 5000.
const std::vector<double>& nominalThirdOctaves();

// The nominal middle nearest to a frequency [Hz], 1258.9 and 1250 alike; nothing where none lies within 3 %.
std::optional<double> nominalThirdOctave(double frequency);

// The exact middle [Hz] of a nominal one, and half the width of a third octave as a ratio.
double middleOfThirdOctave(double nominal);
inline constexpr double kThirdOctaveEdge = 1.1220184543019633;  // 10^0.05

// Root mean squares of the magnitude in the third octaves that lie within the frequencies as a whole.
struct ThirdOctaves {
  std::vector<double> band;   // [Hz] exact middles
  std::vector<double> value;  // in the unit of the values
};
ThirdOctaves thirdOctaves(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values);

}  // namespace squat::receptance
