// tests/verification/TrackBeam.h - the half track as Timoshenko beams: the theory that the solids are held against.
//
// Rail: beam with axial, vertical and rotary motion, exact two-node elements (shear included). Sleepers: beams across
// the track from the symmetry plane (no slope) to the end, that also rock and slide as rigid bodies along the track.
// Pads: 6 x 4 springs over the footprint, ballast under the whole sleeper, vertical and longitudinal. Nothing is taken
// from the solid model but the rail's section integrals, which the caller gives.
#pragma once

#include <Eigen/Sparse>
#include <complex>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::verification {

struct BeamSection {
  double area = 0, inertia = 0, centroidAboveBase = 0;  // [m2], [m4], [m]
  double shearCoefficient = 0.40;
};

class TrackBeam {
 public:
  // Sleepers at the given positions; rail from railStart, of the case's length.
  TrackBeam(const cases::CaseDescription& description, const BeamSection& section, double railStart,
            const std::vector<double>& sleeperPositions);

  // Deflection [m], up positive, at x under the weight of the track and a force [N], down positive, at `loadX`.
  double deflection(double x, double loadX, double force, bool withWeight) const;

  // Displacement at x for a unit harmonic force at x [m/N].
  std::complex<double> receptance(double x, double frequency) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;
  using Terms = std::vector<std::pair<int, double>>;
  // A beam element between two pairs (w, slope) with its mass; EI, kappa A G, rho A, rho I.
  void addBeam(int w0, int slope0, int w1, int slope1, double length, double bending, double shear, double lineMass,
               double rotaryMass);
  void addSpring(const Terms& terms, double stiffness, double damping);
  void addWeight(int unknown, double mass);
  int railNode(double x) const;
  Eigen::VectorXd railShape(double x) const;

  std::vector<double> railX_;
  int unknowns_ = 0;
  Entries stiffness_, damping_, mass_;
  std::vector<std::pair<int, double>> weights_;
  double gravity_ = 0;
};

}  // namespace squat::verification
