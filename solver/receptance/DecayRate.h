// solver/receptance/DecayRate.h - track decay rates after EN 15461, and receptances of an endless track.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "receptance/PeriodicTrack.h"

namespace squat::receptance {

struct EndlessTrackOptions {
  double stationLength = 0.025;  // [m] largest along the rail
  double shapeTolerance = 5e-3;  // of the rail's section shapes (SectionShapes.h)
  int sleeperIntervals = 24;     // along a half sleeper, a multiple of 8
  StruckRails rails = StruckRails::one;
  bool wholeSection = false;  // as PeriodicTrack has it
  int threads = 0;            // 0: all cores
};

struct EndlessTrackResponse {
  std::vector<double> frequency;                                       // [Hz]
  std::vector<std::vector<std::vector<std::complex<double>>>> values;  // per PlaceResponse, per place, per frequency
  int sectionShapes = 0;
  std::size_t unknowns = 0;  // of one bay
  bool complete = false;
};

// Throws CaseError where the case has seats that differ, RunError where nothing damps the track.
EndlessTrackResponse endlessTrackResponse(const scenario::Scenario& scenario, const std::vector<double>& frequency,
                                          const std::vector<PlaceResponse>& wanted, const EndlessTrackOptions& options,
                                          Monitor& monitor);

// Receptance of a sleeper by itself on its ballast at the rail seat [m/N], one a frequency: struck and read over the
// footprint of a pad, one end or, as mirror images, both.
// Throws CaseError where sleepers are fixed; empty where it was cancelled.
std::vector<std::complex<double>> sleeperReceptance(const scenario::Scenario& scenario,
                                                    const std::vector<double>& frequency, StruckRails rails,
                                                    int threads, Monitor& monitor);

// The 29 positions of EN 15461 in bays from the accelerometer at midspan, its own first.
const std::vector<double>& decayPositions();

// 4.343 / sum |A(x_n)|^2 / |A(x_0)|^2 dx_n [dB/m]; squares one a position of decayPositions(), `bay` [m].
double decayRate(const std::vector<double>& squares, double bay);

// Lower limits of a track on which vehicles are tested, ISO 3095:2013, Figure 3; not-a-number outside its bands.
double decayLimit(double band, RailDirection direction);

struct DecayRates {
  std::vector<double> band;               // [Hz] nominal middles of third octaves
  std::vector<double> vertical, lateral;  // [dB/m]
  double smallest = 0;  // [dB/m] 4.343 / x_max: what the positions can tell; twice that counts as measured (clause 7)
  int sectionShapes = 0;
  std::vector<std::string> notes;
  bool complete = false;
};

struct DecayOptions {
  EndlessTrackOptions track;
  double lowest = 100, highest = 5000;  // [Hz] nominal middles of the first and the last third octave
  int linesPerBand = 8;                 // frequencies, in equal ratios; squares are averaged over them
};

DecayRates trackDecayRates(const scenario::Scenario& scenario, const DecayOptions& options, Monitor& monitor);

}  // namespace squat::receptance
