// solver/detection/WavyStretches.h - where the power of a record lies at one wavelength over many metres.
#pragma once

#include <cstddef>
#include <vector>

#include "detection/BandPower.h"
#include "detection/Segments.h"

namespace squat::detection {

// Corrugation that is longer than the window of the local level makes no event: it is the level. It shows in the
// spectrum: a wavelength holds a large share of the power above 30 Hz. So does a resonance, at one frequency: only a
// speed that varies tells them apart.
struct WavyStretch {
  double time = 0;                   // [s] at which it begins
  double from = 0, to = 0;           // [m] as the record counts, in the order of travel
  double wavelength = 0;             // [m] mean
  double shortest = 0, longest = 0;  // [m] of its pieces
  double share = 0;                  // [0..1] of the power within 15 % of the wavelength
  double slowest = 0, fastest = 0;   // [m/s] speeds over which the wavelength was the same
  double prominence = 0;             // power a hertz within 15 % of the wavelength by that of the stronger side
};

// Pieces of 8 m of one channel within the segment's core; wavelengths from 20 mm to 0.4 m, so that sleepers are left
// out. Each is judged by the median spectrum of windows of 4 m within 16 m: single impacts do not count. The wavelength
// must stand out of those beside it, as a broad swell of the roughness does not. `power` of the
// channel: that of the wavelength's band must be there all the time, as impacts that repeat are not.
std::vector<WavyStretch> wavyStretches(const Segment& segment, std::size_t channel, const BandPower& power);

// Joins those that follow each other with the same wavelength, and drops what is not about 16 m long or does not stand
// out from the wavelengths beside it.
std::vector<WavyStretch> joined(const std::vector<WavyStretch>& pieces);

}  // namespace squat::detection
