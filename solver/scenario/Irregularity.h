// solver/scenario/Irregularity.h - a rail that is not smooth: heights along the whole rolled length, beside the defect.
//
// From a spectrum of third octaves of wavelength, h(x) is a sum of harmonics with random phases, 64 in each third
// octave. In expectation, which for harmonics is their mean over a long way, each third octave has its level exactly:
//   sum of A^2 / 2 = (1 um)^2 10^(L / 10).
// Within and between third octaves the density follows the levels, straight in dB over the logarithm of the wavelength;
// nothing lies outside the table. The random numbers are the upper 53 bits of std::mt19937_64, whose outputs the
// standard prescribes: phases and wavelengths are the same on every machine. Each third octave has its own generator,
// so other limits leave the waves within them as they are.
//
// From heights, h(x) goes through the points, a monotone cubic between them (ProfileCurve.h).
//
// Where the wheel stands at the start, h is zero, and level over the patch: what is laid is the height above that of
// the starting point, faded in over the 50 mm in front of the patch. The run starts in equilibrium.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenario/Defect.h"
#include "scenario/ProfileCurve.h"

namespace squat::scenario {

enum class IrregularityKind { none, iso3095, spectrum, heights };

// Mean square of the heights in one third octave of wavelength.
struct WavelengthLevel {
  double wavelength = 0;  // [m] middle of the band
  double level = 0;       // [dB re 1 um]
};

// What a user writes.
struct Irregularity {
  IrregularityKind kind = IrregularityKind::none;
  std::string file;                  // of levels or heights, as the case names it
  std::string levels;                // of a spectrum, as text (case/LevelsText.h)
  std::vector<ProfilePoint> points;  // heights
  double position = 0;               // [m] of the heights' axis that lies at x = 0
  double offset = 0;                 // [dB] added to all levels; heights times 10^(offset / 20)
  double seed = 0;                   // whole number
  double shortest = 0, longest = 0;  // [m] middles of the outermost third octaves of a spectrum
};

// The limit of ISO 3095:2013 for the roughness of a test track, 0.4 m to 3.15 mm [m, dB re 1 um]. As reprinted in
// Directive (EU) 2015/996, table G-1, for "EN ISO 3095:2013"; to be checked against the standard before an acceptance
// rests on it.
const std::vector<WavelengthLevel>& iso3095Limit();

// Middles of the third octaves of wavelength, 10^(k/10) m, from shortest to longest, both included where they are
// nominal ones (0.63 for 0.631), ascending.
std::vector<double> thirdOctaveWavelengths(double shortest, double longest);

// Level at a wavelength, straight over its logarithm; minus infinity outside the table. Tables ascend; a wavelength
// within 2 % of a row is that row, since tables state nominal ones.
double levelAt(const std::vector<WavelengthLevel>& table, double wavelength);

class IrregularSurface {
 public:
  IrregularSurface() = default;  // a smooth rail
  // Of a table with ascending wavelengths. `start` [m]: where the wheel stands at first.
  static IrregularSurface ofSpectrum(const std::vector<WavelengthLevel>& table, const Irregularity& options,
                                     double start);
  static IrregularSurface ofHeights(const Irregularity& options, double start);

  bool isSmooth() const { return harmonics_.empty() && curve_.empty(); }
  double height(double x) const;                 // [m] as laid
  double steepest() const { return steepest_; }  // bound of |dh/dx|, of a spectrum five times its root mean square

  struct Harmonic {
    double wavenumber = 0, amplitude = 0, phase = 0;  // [rad/m], [m], [rad]: A cos(k x + phase)
  };
  const std::vector<Harmonic>& harmonics() const { return harmonics_; }

 private:
  double raw(double x) const;
  void settle(double start);

  std::vector<Harmonic> harmonics_;
  ProfileCurve curve_{{}, 1, false};
  double start_ = 0, atStart_ = 0, steepest_ = 0;
};

}  // namespace squat::scenario
