// tests/verification/BeamSystem.h - stiffness, damping and mass of beams, bars and springs, entry by entry.
#pragma once

#include <Eigen/Sparse>
#include <complex>
#include <utility>
#include <vector>

namespace squat::verification {

using Terms = std::vector<std::pair<int, double>>;  // a weighted sum of unknowns

class BeamSystem {
 public:
  // New unknowns; the first of them.
  int add(int count);
  int unknowns() const { return unknowns_; }

  // Timoshenko beam element between two pairs (deflection, slope), exact at rest: EI, kappa A G. Masses lumped, which
  // needs elements that are short against every wave.
  void addBeam(int left, int slopeLeft, int right, int slopeRight, double length, double bending, double shear,
               double lineMass, double rotaryMass);
  // Twist and its derivative at both ends: G J, E C_w (cubic; Vlasov), rotary inertia per length.
  void addTwist(int left, int rateLeft, int right, int rateRight, double length, double torsion, double warping,
                double rotaryMass);
  // Linear element: stiffness times length, mass per length.
  void addBar(int left, int right, double length, double stiffness, double lineMass);
  void addSpring(const Terms& terms, double stiffness, double damping);
  // Carries only where its ends have come closer by more than `gap`: k (q + gap) for q < -gap. At rest only.
  void addGapSpring(const Terms& terms, double stiffness, double gap);
  void addMass(const Terms& terms, double mass);
  void hold(int unknown) { addSpring({{unknown, 1}}, 1e15, 0); }

  // With gap springs: by the set of closed ones.
  Eigen::VectorXd atRest(const Eigen::VectorXd& load) const;
  double gapLoad(const Eigen::VectorXd& displacement) const;  // [N] that all gap springs carry, compression positive
  // Answer of every shape (column) to a unit harmonic force along itself.
  std::vector<std::complex<double>> answers(const Eigen::MatrixXd& shapes, double omega) const;
  // Answer along every shape (row) to a force along every shape (column) that varies with exp(i omega t), omega
  // complex: [rad/s], with a negative imaginary part it grows.
  Eigen::MatrixXcd transfers(const Eigen::MatrixXd& shapes, std::complex<double> omega) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;
  struct GapSpring {
    Terms terms;
    double stiffness = 0, gap = 0;
    double compression(const Eigen::VectorXd& displacement) const;  // beyond the gap [m]
  };
  void addElement(Entries& to, const int (&at)[4], const double (&matrix)[4][4], double factor);

  int unknowns_ = 0;
  Entries stiffness_, damping_, mass_;
  std::vector<GapSpring> gapSprings_;
};

}  // namespace squat::verification
