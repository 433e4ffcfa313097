// Bending modes of a free thin ring in its plane, made by the sweep around the axis.
// Theory: R. Hoppe (1871), A. E. H. Love, Mathematical Theory of Elasticity, 293:
//   w_n^2 = n^2 (n^2 - 1)^2 / (n^2 + 1) E I / (rho A R^4), n = 2, 3, ...
// with E for a ring that is narrow along its axis. Tolerance 2 %: shear and rotary inertia lower w_n by about
// n^2 (h / R)^2 (1 + E / kappa G) / 24, 0.6 % for n = 4 and h / R = 1/20; the polygon of 96 sectors adds 0.1 %.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "elasticity/SweptSamples.h"
#include "verification/Seen.h"

namespace squat::elasticity {
namespace {

constexpr double ringRadius = 0.4, ringHeight = 0.02, ringWidth = 0.02;
constexpr int sectors = 96;

std::vector<SweptBlock> ring(int quads) {
  SweptBlock block;
  block.name = "ring", block.kind = SweepKind::aroundAxis, block.material = steel;
  block.section = gridSection(evenly(ringRadius - ringHeight / 2, ringRadius + ringHeight / 2, quads),
                              evenly(-ringWidth / 2, ringWidth / 2, quads));
  block.stations = {0, true, {{sectors, 2 * std::acos(-1.0) / sectors}}};
  return {block};
}

struct RingMode {
  double frequency = 0;  // [rad/s]
  double inPlane = 0;    // share of the kinetic energy without motion along the axis
};

// Modes in which motion in the section varies as cos(n alpha) and along the sweep as sin(n alpha): the ring is the same
// at every station, so forces and displacements of one station are joined by a small matrix, taken from unit
// displacements of one station.
std::vector<RingMode> modesOfOrder(int n, int quads) {
  auto blocks = ring(quads);
  const std::size_t size = layOut(blocks);
  const auto& block = blocks[0];
  const int unknowns = block.nodes * 3, at = 24;
  const auto mass = lumpedMass(block);
  Eigen::MatrixXd k(unknowns, unknowns);
  Eigen::VectorXd inverseRoot(unknowns);
  const double angle = n * 2 * std::acos(-1.0) / sectors;
  for (int j = 0; j < unknowns; ++j) {
    AlignedVector unit(size, 0.0);
    unit[block.index(j / 3, j % 3, at)] = 1;
    const AlignedVector force = applySwept(blocks, unit, "");
    for (int i = 0; i < unknowns; ++i) {
      // What station s feels from `at` is what `at` feels from its neighbour on the other side, at -(s - at).
      const bool rowAlong = i % 3 == 0, columnAlong = j % 3 == 0;
      double sum = 0;
      for (const int s : {at - 1, at, at + 1}) {
        const double phase = (at - s) * angle, f = force[block.index(i / 3, i % 3, s)];
        sum += f * (rowAlong == columnAlong ? std::cos(phase) : columnAlong ? -std::sin(phase) : std::sin(phase));
      }
      k(i, j) = sum;
    }
    inverseRoot[j] = 1 / std::sqrt(mass[(j / 3) * block.stride + at]);
  }
  EXPECT_LT((k - k.transpose()).norm(), 1e-12 * k.norm());
  const Eigen::MatrixXd scaled = inverseRoot.asDiagonal() * k * inverseRoot.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  std::vector<RingMode> modes;
  for (int m = 0; m < 4; ++m) {
    RingMode mode;
    mode.frequency = std::sqrt(std::max(0.0, solver.eigenvalues()[m]));
    for (int i = 0; i < unknowns; ++i)
      if (i % 3 != 2) mode.inPlane += std::pow(solver.eigenvectors()(i, m), 2);
    modes.push_back(mode);
  }
  return modes;
}

double lowestInPlane(int n) {
  for (const RingMode& mode : modesOfOrder(n, 2))
    if (mode.inPlane > 0.9) return mode.frequency;
  return 0;
}

TEST(RingModes, BendInTheirPlaneAfterHoppe) {
  const double area = ringWidth * ringHeight, inertia = ringWidth * std::pow(ringHeight, 3) / 12;
  for (const int n : {2, 3, 4}) {
    const double squares = n * n;
    const double expected = std::sqrt(squares * std::pow(squares - 1, 2) / (squares + 1) * steel.young * inertia /
                                      (steel.density * area * std::pow(ringRadius, 4)));
    const double found = lowestInPlane(n);
    EXPECT_NEAR(found, expected, 0.02 * expected) << "n = " << n;
    verification::seenDeviation("in the plane", found, expected);
  }
}

// Out of the plane: w_n^2 = n^2 (n^2 - 1)^2 / (n^2 + E I / C) E I / (rho A R^4) (Love, 293b), with the torsional
// stiffness C = 0.1406 G b^4 of a square. Six quads a side: the warping of the section must be seen.
TEST(RingModes, BendOutOfTheirPlaneAfterLove) {
  const double area = ringWidth * ringHeight, inertia = ringHeight * std::pow(ringWidth, 3) / 12;
  const double shear = steel.young / 2 / (1 + steel.poisson), torsion = 0.1406 * shear * std::pow(ringWidth, 4);
  for (const int n : {2, 3}) {
    const double squares = n * n;
    const double expected = std::sqrt(squares * std::pow(squares - 1, 2) / (squares + steel.young * inertia / torsion) *
                                      steel.young * inertia / (steel.density * area * std::pow(ringRadius, 4)));
    double found = 0;
    for (const RingMode& mode : modesOfOrder(n, 6))
      if (mode.inPlane < 0.1 && found == 0) found = mode.frequency;
    EXPECT_NEAR(found, expected, 0.02 * expected) << "n = " << n;
    verification::seenDeviation("out of the plane", found, expected);
  }
}

// n = 1 and n = 0 hold the rigid motions: translations and the turn about the axis.
TEST(RingModes, RigidMotionsHaveNoFrequency) {
  const double second = lowestInPlane(2);
  const auto one = modesOfOrder(1, 2), zero = modesOfOrder(0, 2);
  for (int m = 0; m < 2; ++m) {
    EXPECT_LT(one[m].frequency, 1e-4 * second);   // along x or z, and tilt
    EXPECT_LT(zero[m].frequency, 1e-4 * second);  // turn, and along y
  }
  EXPECT_GT(one[2].frequency, second);
  EXPECT_GT(zero[2].frequency, second);
}

}  // namespace
}  // namespace squat::elasticity
