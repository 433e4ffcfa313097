// solver/receptance/Receptance.h - what the assembled track answers to a harmonic force, and the wheelset's modes.
//
// Direct harmonic solution of the track without the wheelset (TrackSystem.h, HarmonicResponse.h), over a sleeper and at
// midspan near the middle of the track. Force spread over 10 x 10 mm of the running surface, response the mean
// displacement of the section: what a beam theory can be compared with. Pads, ballast and absorbing ends damp; the
// material's own damping, some 1e-4 of critical at 1 kHz by default, is left out.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "model/WheelsetModes.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::receptance {

struct ReceptanceOptions {
  double lowest = 50, highest = 2000, frequencyStep = 1;  // [Hz]
  int threads = 0;                                        // 0: all cores
  bool wheelset = true;                                   // modes up to `highest`
  double shapeTolerance = 1e-3;                           // of the rail's section shapes (SectionShapes.h)
  double accuracy = 0.005;                                // of what is interpolated (HarmonicResponse.h)
};

struct PointReceptance {
  std::string name;                              // "over a sleeper", "midspan"
  double position = 0;                           // [m]
  std::vector<std::complex<double>> receptance;  // [m/N], phase negative where the response lags
};

struct TrackReceptance {
  std::vector<double> frequency;  // [Hz]
  std::vector<PointReceptance> points;
  std::vector<model::HarmonicMode> modes;
  std::size_t elements = 0, unknowns = 0;  // of the track; unknowns of the system that was solved
  int sectionShapes = 0;                   // of the rail
  int solutions = 0;                       // frequencies that were solved directly
  double difference = 0;                   // largest of direct solutions from what is interpolated between them
  std::vector<std::string> notes;
  bool complete = false;
};

// The case's track on a mesh for vibrations up to 2 kHz: 20 mm along the rail near the points, at most 50 mm
// elsewhere, no defect; the section as the case has it, but not finer than 12 mm. The wheel plays no part.
scenario::Scenario receptanceCase(const scenario::Scenario& scenario);

// Throws CaseError where the case cannot be meshed. A cancelled call returns what it has, with complete == false.
TrackReceptance trackReceptance(const scenario::Scenario& scenario, const ReceptanceOptions& options, Monitor& monitor);

// Local maxima of the magnitude [Hz], refined by a parabola through three points; those at least `minimum` [dB] above
// the higher of the two valleys beside them.
std::vector<double> resonances(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values,
                               double minimum = 1);

}  // namespace squat::receptance
