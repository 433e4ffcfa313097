// tests/verification/TrackBeam.h - the half track as beams: the theory that the solids are held against.
//
// Rail: vertical Timoshenko beam with rotary inertia; stretch; lateral bending about the shear centre and Vlasov's
// torsion, which the bending sleepers turn it into. Half sleepers: beams across the track from the track centre to the
// end that bend vertically and horizontally, stretch and twist; at the centre without slopes and lateral motion, or,
// where both rails move oppositely, without all else. Pads: 6 x 4 springs
// over the footprint, ballast under the whole base, both in three directions. Rail ends are free. Sections keep their
// shape: that alone is left out. Nothing is taken from the solid model but the section that the caller gives.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "geometry/SectionMesh.h"
#include "scenario/Scenario.h"
#include "verification/BeamSystem.h"

namespace squat::verification {

struct BeamSection {
  double area = 0, inertia = 0, centroidAboveBase = 0;  // [m2], [m4], [m]
  double shearCoefficient = 0.40;
  // Lateral inertia [m4], St Venant's constant [m4], warping constant [m6], shear centre above the base [m].
  double lateralInertia = 419.2e-8, torsion = 159.5e-8, warping = 0, shearCentreAboveBase = centroidAboveBase;
  double lateralShearCoefficient = 0.5;  // foot and head carry; it hardly matters here
  double footFlexibility = 0;            // [m2/N] between section and pad (SectionFlexibility.h)
};

// [m] at a distance from the track centre: level, a straight rise to the pad, level.
double sleeperHeight(const scenario::Scenario& description, double fromCentre);

BeamSection beamSection(const geometry::SectionMesh& section);

class TrackBeam {
 public:
  // How the rails move to each other.
  enum class Rails { alike, oppositely };
  // Sleepers at the given positions; rail from railStart, of the case's length.
  TrackBeam(const scenario::Scenario& description, const BeamSection& section, double railStart,
            const std::vector<double>& sleeperPositions, Rails rails = Rails::alike);

  // Deflection [m], up positive, at x under the weight of the track and a force [N], down positive, at `loadX`.
  double deflection(double x, double loadX, double force, bool withWeight) const;
  // What the ballast of all seats with a gap carries [N], weight of the track included.
  double voidedLoad(double loadX, double force) const;

  // Displacement at each x for a unit harmonic force there [m/N].
  std::vector<std::complex<double>> receptance(const std::vector<double>& at, double frequency) const;
  // Between all of these places [m/N], at a complex angular frequency (BeamSystem.h).
  Eigen::MatrixXcd transfers(const std::vector<double>& at, std::complex<double> omega) const;

 private:
  // Unknowns of a node of the rail, and of a sleeper.
  enum Rail { along, up, upSlope, across, acrossSlope, turn, turnRate, railUnknowns };
  enum Sleeper { stretch, lift, liftSlope, shift, shiftSlope, twist, sleeperUnknowns };

  void layRail(const std::vector<double>& sleeperPositions);
  int addSleeper(Rails rails);
  scenario::Seat seatAt(double x) const;
  void addBallast(int sleeper, const scenario::Seat& seat);
  void addPad(int sleeper, double at, const scenario::Seat& seat);
  int railNode(double x) const;
  // Weights of a sleeper's unknown at a distance from the symmetry plane.
  Terms sleeperAt(int sleeper, int unknown, double y, double factor) const;
  Eigen::VectorXd railShape(double x) const;
  Eigen::MatrixXd railShapes(const std::vector<double>& at) const;
  Eigen::VectorXd atRest(double loadX, double force, bool withWeight) const;

  scenario::Scenario case_;
  BeamSection section_;
  double railStart_ = 0;
  std::vector<double> railX_;
  BeamSystem system_;
  std::vector<std::pair<int, double>> weights_;  // [kg]
};

}  // namespace squat::verification
