// solver/detection/BandPower.h - power of an axle box acceleration in bands along the record.
#pragma once

#include <string>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::detection {

struct DetectionBand {
  std::string name;
  double low = 0, high = 0;  // [Hz]
};

// From the slow dip of a joint or weld to the short waves of an impact. The second and the fifth are those in which the
// paper sees squats (Molodova et al. 2014, section 4).
const std::vector<DetectionBand>& detectionBands();

// Scale-averaged wavelet power (Torrence and Compo 1998, eq. 24) in each band, on one grid of cells: the band's part of
// the mean square, so that white noise of variance s^2 at the rate f has s^2 (high - low) / (f / 2) in it. Morlet
// wavelet of signals/ContinuousWavelet.h, six voices an octave. The factor before the sum is 2.7 % larger than that of
// eq. 24: pi / (w0 ln 2) = 0.755, which white noise asks for, in place of C_delta = 0.776, which rebuilds a delta.
struct BandPower {
  double start = 0, step = 0;              // [s] centre of the first cell; length of a cell
  std::size_t cell = 1;                    // samples in a cell
  std::vector<std::vector<double>> power;  // [unit^2] a row for each band, a value for each cell

  std::size_t cells() const { return power.empty() ? 0 : power.front().size(); }
  double timeAt(std::size_t i) const { return start + step * static_cast<double>(i); }
};

// Cells of about a millisecond. Bands that reach beyond 0.45 of the sampling rate have no power. Throws SignalError for
// a series that is constant or not finite.
BandPower bandPower(const signals::TimeSeries& series);

// Whether a record of this rate [Hz] shows the band.
bool shows(double rate, const DetectionBand& band);

// Independent values of a band's power within `duration` [s]: twice the product of bandwidth and time, at least one.
double degreesOfFreedom(const DetectionBand& band, double duration);

}  // namespace squat::detection
