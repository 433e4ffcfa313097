// solver/growth/Shape.h - dip and wave in a profile along the rail.
#pragma once

#include <vector>

namespace squat::growth {

struct Dip {
  double depth = 0, place = 0, length = 0;  // [m] positive; of the deepest point; between 5 % of the depth
};
Dip dipOf(const std::vector<double>& x, const std::vector<double>& height);

struct Wave {
  double length = 0, height = 0;  // [m] of the strongest one, crest to valley; zero where there is none
};
struct WaveSpectrum {
  std::vector<double> length, height;  // [m]; height crest to valley of a sine in the Hann window
};
inline constexpr double shortestWave = 0.010, longestWave = 0.080;  // [m] that are looked for

// Of `height` from `from` to `to` [m], its line of best fit taken off: projections on sines through a Hann window.
WaveSpectrum waveSpectrum(const std::vector<double>& x, const std::vector<double>& height, double from, double to);
// The highest maximum of a spectrum that is not at its ends.
Wave strongestWave(const WaveSpectrum& spectrum);

}  // namespace squat::growth
