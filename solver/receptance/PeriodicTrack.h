// solver/receptance/PeriodicTrack.h - an endless track of equal bays under a harmonic force.
//
// One bay, midspan to midspan, is condensed to the unknowns of its two ends; from two such cells that share an end
// follows one of twice the length, so a dozen doublings give the half track that reaches to where no wave comes back
// from. With it at both ends of the loaded bay the rest is substitution. No wave is reflected, and a bay far away costs
// two small products: what a decay rate needs. Sleepers that differ have no place here (Receptance.h).
#pragma once

#include <complex>
#include <vector>

#include "receptance/TrackSystem.h"

namespace squat::receptance {

// Where a rail is struck or read; position 0: over a sleeper [m].
struct RailPlace {
  double position = 0;
  RailDirection direction = RailDirection::vertical;
};

// Places that answer to 1 N at another.
struct PlaceResponse {
  RailPlace struck;
  std::vector<RailPlace> read;
};

class PeriodicTrack {
 public:
  // A system of model::buildTrackCell(); its rail head is struck and read (TrackSystem::headMean), or, where
  // `wholeSection`, downwards a square of the running surface struck and the whole section read (Receptance.h).
  // The cell must outlive the track; `bay` [m].
  PeriodicTrack(const TrackSystem& cell, double bay, bool wholeSection = false);

  // Receptance [m/N] of each place that is read, one row an element of `wanted`. Safe to call from several threads.
  std::vector<std::vector<std::complex<double>>> response(double omega, const std::vector<PlaceResponse>& wanted) const;

 private:
  struct Local {
    int cell = 0, direction = 0;
    double position = 0;  // [m] in its cell
  };
  Local localOf(const RailPlace& place) const;
  Eigen::VectorXd reading(const Local& place) const;
  Eigen::VectorXd loading(const Local& place) const;

  const TrackSystem& cell_;
  double bay_;
  bool wholeSection_;
  DynamicStiffness stiffness_;
};

// Dynamic stiffness of the endless halves, as the end that they begin with sees them.
struct HalfTracks {
  Eigen::MatrixXcd before, behind;
};
// Of a cell's condensed stiffness, unknowns of its first end, then those of its last one, as many. Throws RunError
// where waves do not decay.
HalfTracks halfTracks(const Eigen::MatrixXcd& cell);

}  // namespace squat::receptance
