// Cantilever under an end load, static.
// Theory: S. P. Timoshenko, beam with shear deformation: w = F L^3 / 3 E I + F L / (kappa G A); kappa for a rectangle
// 10 (1 + nu) / (12 + 11 nu) (G. R. Cowper, Journal of Applied Mechanics 33, 1966).
// Tolerance 2 %: Saint-Venant's end effects at the clamped face are of the order of (height / length) times a few
// percent; the incompatible modes leave next to nothing of the mesh.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include "elasticity/SweptSamples.h"
#include "verification/Seen.h"

namespace squat::elasticity {
namespace {

constexpr double beamLength = 0.5, beamWidth = 0.04, beamHeight = 0.05;

// Mean deflection of the loaded end face along section coordinate c, load 1 N spread evenly by area.
double endDeflection(SweepKind kind, double skew) {
  SweptBlock bar;
  bar.name = "cantilever", bar.kind = kind, bar.material = steel;
  bar.section = gridSection(evenly(-beamWidth / 2, beamWidth / 2, 3), evenly(-beamHeight / 2, beamHeight / 2, 4), skew);
  bar.stations = {0, false, {{8, 0.03}, {8, 0.0325}}};
  std::vector<SweptBlock> blocks{bar};
  const std::size_t size = layOut(blocks);
  const auto& b = blocks[0];
  // Shares of the end face that belong to its nodes: the lumped mass at the last station.
  const auto mass = lumpedMass(b);
  double total = 0;
  for (int n = 0; n < b.nodes; ++n) total += mass[n * b.stride + b.intervals];

  const auto k = plainMatrix(blocks, size);
  std::vector<int> number(size, -1);
  int unknowns = 0;
  for (int n = 0; n < b.nodes; ++n)
    for (int s = 1; s < b.stationCount; ++s)
      for (int c = 0; c < 3; ++c) number[b.index(n, c, s)] = unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < k.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator at(k, column); at; ++at)
      if (number[at.row()] >= 0 && number[column] >= 0)
        entries.emplace_back(number[at.row()], number[column], at.value());
  Eigen::SparseMatrix<double> reduced(unknowns, unknowns);
  reduced.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns);
  for (int n = 0; n < b.nodes; ++n) load[number[b.index(n, 2, b.intervals)]] = mass[n * b.stride + b.intervals] / total;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(reduced);
  const Eigen::VectorXd u = factor.solve(load);

  // The same displacements must balance the load in the swept operator.
  AlignedVector state(size, 0.0);
  for (std::size_t i = 0; i < size; ++i)
    if (number[i] >= 0) state[i] = u[number[i]];
  const AlignedVector force = applySwept(blocks, state, "");
  for (std::size_t i = 0; i < size; ++i)
    if (number[i] >= 0) {
      EXPECT_NEAR(force[i], load[number[i]], 1e-8);
    }
  return load.dot(u);
}

TEST(Cantilever, DeflectsAfterTimoshenko) {
  const double area = beamWidth * beamHeight, inertia = beamWidth * beamHeight * beamHeight * beamHeight / 12;
  const double shear = steel.young / 2 / (1 + steel.poisson);
  const double kappa = 10 * (1 + steel.poisson) / (12 + 11 * steel.poisson);
  const double expected =
      beamLength * beamLength * beamLength / (3 * steel.young * inertia) + beamLength / (kappa * shear * area);
  const std::tuple<SweepKind, double> bars[] = {
      {SweepKind::alongX, 0}, {SweepKind::alongY, 0}, {SweepKind::alongX, 0.3}};  // the last has a distorted section
  for (const auto& [kind, skew] : bars) {
    const double found = endDeflection(kind, skew);
    EXPECT_NEAR(found, expected, 0.02 * expected) << "skew " << skew;
    verification::seenDeviation("deflection", found, expected);
  }
}

}  // namespace
}  // namespace squat::elasticity
