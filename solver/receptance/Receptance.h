// solver/receptance/Receptance.h - what the assembled track answers to a harmonic force, and the wheelset's modes.
//
// Direct harmonic solution of the track without the wheelset (TrackSystem.h, HarmonicResponse.h), over a sleeper and at
// midspan near the middle of the track, or at other places. Vertical force spread over 10 x 10 mm of the running
// surface, response the mean displacement of the section: what a beam theory can be compared with; sideways both are
// those of the head. Pads, ballast, absorbing ends and loss factors damp; the material's own damping of the rolling
// run, some 1e-4 of critical at 1 kHz by default, is left out. On an endless track (PeriodicTrack.h) frequencies stand
// in equal ratios.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "model/WheelsetModes.h"
#include "receptance/TrackSystem.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::receptance {

// Where the rail is struck and where it is read; 0: over a sleeper.
struct ReceptancePlace {
  std::string name;             // "over a sleeper", "midspan"
  double struck = 0, read = 0;  // [m]
  RailDirection direction = RailDirection::vertical;
};

struct ReceptanceOptions {
  double lowest = 50, highest = 2000, frequencyStep = 1;  // [Hz]
  int threads = 0;                                        // 0: all cores
  bool wheelset = true;                                   // modes up to `highest`
  double shapeTolerance = 1e-3;                           // of the rail's section shapes (SectionShapes.h)
  double accuracy = 0.005;                                // of what is interpolated (HarmonicResponse.h)
  std::vector<ReceptancePlace> places;                    // none: over a sleeper and at midspan, vertical
  StruckRails rails = StruckRails::both;
  bool endless = false;
};

struct PointReceptance : ReceptancePlace {
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
  std::string how;                         // what was struck and read, in words
  std::vector<std::string> notes;
  bool complete = false;
};

// The case's track on a mesh for vibrations up to 2 kHz: 20 mm along the rail near the points, at most 50 mm
// elsewhere, no defect; the section as the case has it, but not finer than 12 mm. The wheel plays no part.
scenario::Scenario receptanceCase(const scenario::Scenario& scenario);

// Throws CaseError where the case cannot be meshed or a place lies beyond the rail, RunError where nothing damps an
// endless track. A cancelled call returns an empty result with complete == false.
TrackReceptance trackReceptance(const scenario::Scenario& scenario, const ReceptanceOptions& options, Monitor& monitor);

// The same of a sleeper by itself on its ballast, struck and read at the rail seat, one end or both, at frequencies in
// equal ratios; no wheelset modes. Throws CaseError where sleepers are fixed.
TrackReceptance sleeperByItself(const scenario::Scenario& scenario, const ReceptanceOptions& options, Monitor& monitor);

// What the values stand for: displacement, velocity or acceleration over force.
enum class ReceptanceQuantity { receptance, mobility, accelerance };
const char* unitOf(ReceptanceQuantity quantity);
// Times i w once or twice.
std::vector<std::complex<double>> asQuantity(const std::vector<double>& frequency,
                                             const std::vector<std::complex<double>>& receptance,
                                             ReceptanceQuantity quantity);

// Local maxima of the magnitude [Hz], refined by a parabola through three points; those at least `minimum` [dB] above
// the higher of the two valleys beside them.
std::vector<double> resonances(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values,
                               double minimum = 1);

}  // namespace squat::receptance
