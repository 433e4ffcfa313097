// solver/roughness/HeightSpectrum.h - heights as levels of third octaves of wavelength, and how well they are known.
#pragma once

#include <vector>

#include "signals/PowerSpectrum.h"

namespace squat::roughness {

// A third octave of wavelength, 10^(k/10) m in its middle.
struct WavelengthBand {
  double middle = 0, shortest = 0, longest = 0;  // [m]
};
// Those whose middles lie between the limits, ascending; a nominal limit (0.63 for 0.631) counts as the exact one.
std::vector<WavelengthBand> wavelengthBands(double shortest, double longest);

// Spectrum of one stretch of samples at this rate (of heights along the rail: 1 / spacing), straight line taken off,
// Hann's window, four points a line of its resolution.
signals::PowerSpectrum stretchSpectrumOf(const std::vector<double>& values, double rate);

// The same without a window, of one that begins and ends at rest.
signals::PowerSpectrum quietSpectrumOf(const std::vector<double>& values, double rate);

// Mean squares of heights [m2] in these bands; spectrum over wavenumber [1/m], or over frequency at `speed` [m/s].
// Not-a-number where the spectrum ends below the band.
std::vector<double> bandSquares(const signals::PowerSpectrum& spectrum, const std::vector<WavelengthBand>& bands,
                                double speed = 1);

// Levels [dB re 1 um] of equally spaced heights [m].
std::vector<double> heightLevels(const std::vector<double>& heights, double spacing,
                                 const std::vector<WavelengthBand>& bands);

double levelOfSquare(double square);  // [dB re 1 um] of a mean square [m2]

// Degrees of freedom of a band's mean square over a stretch: twice band width times length, at least one; those of a
// Hann window that stands once see about half of it.
double degreesOfFreedom(const WavelengthBand& band, double length, bool once);

// What a mean square with so many degrees of freedom may differ from its expectation [dB]: 95 of 100 times the expected
// level is between level - below and level + above. Chi-square after Wilson and Hilferty (1931), good to 0.2 dB
// from three degrees on.
struct CountSpread {
  double below = 0, above = 0;
};
CountSpread countSpread(double degreesOfFreedom);

}  // namespace squat::roughness
