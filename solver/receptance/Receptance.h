// solver/receptance/Receptance.h - what the assembled track answers to a harmonic force, and the wheelset's modes.
//
// The rail is struck (TrackImpulse.h) over a sleeper and at midspan, near the middle of the track; the receptance is
// the ratio of the Fourier integrals of response and force over the whole record, no window: pads and ballast have
// damped the record out by then (`left` tells). Force spread over 10 x 10 mm of the running surface, response the mean
// displacement of the section: what a beam theory can be compared with.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Monitor.h"
#include "model/WheelsetModes.h"

namespace squat::receptance {

struct ReceptanceOptions {
  double lowest = 50, highest = 2000, frequencyStep = 1;  // [Hz]
  double duration = 0.4;                                  // [s] of each record at most
  int threads = 0;                                        // 0: all cores
  std::string isa;                                        // empty: the best there is
  bool wheelset = true;                                   // modes up to `highest`
};

struct PointReceptance {
  std::string name;                              // "over a sleeper", "midspan"
  double position = 0;                           // [m]
  std::vector<std::complex<double>> receptance;  // [m/N], phase negative where the response lags
  double left = 0;                               // see ImpulseRecord
};

struct TrackReceptance {
  std::vector<double> frequency;  // [Hz]
  std::vector<PointReceptance> points;
  std::vector<model::HarmonicMode> modes;
  double step = 0, duration = 0;  // [s]
  std::size_t elements = 0;       // of the track
  std::vector<std::string> notes;
  bool complete = false;
};

// The case's track on a mesh for vibrations up to 2 kHz: 10 mm along the rail where it is struck, 25 to 37.5 mm
// elsewhere, no defect; the section as the case has it, but not finer than 12 mm. The wheel plays no part.
cases::CaseDescription receptanceCase(const cases::CaseDescription& description);

// Throws CaseError where the case cannot be meshed, RunError where the stepping diverges. A cancelled call returns what
// it has, with complete == false.
TrackReceptance trackReceptance(const cases::CaseDescription& description, const ReceptanceOptions& options,
                                Monitor& monitor);

// Local maxima of the magnitude [Hz], refined by a parabola through three points; those at least 1 dB above the higher
// of the two valleys beside them.
std::vector<double> resonances(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values);

}  // namespace squat::receptance
