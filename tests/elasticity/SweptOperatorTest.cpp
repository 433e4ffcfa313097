// The swept operator against the plain sum of element matrices, rigid motions, constant strain, and threads.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "elasticity/SweptKernel.h"
#include "elasticity/SweptSamples.h"

namespace squat::elasticity {
namespace {

struct Sample {
  const char* name;
  std::vector<SweptBlock> blocks;
  std::size_t size = 0;
};

SweptBlock lineBlock(SweepKind kind) {
  SweptBlock block;
  block.name = "bar";
  block.kind = kind;
  block.section = gridSection({-0.03, -0.01, 0.005, 0.03}, {0, 0.02, 0.035}, 0.25);
  // A group of 32 intervals with three lengths, one with a single length; openArc() has a group that is not whole.
  block.stations = {-0.2, false, {{16, 0.0013}, {8, 0.0026}, {40, 0.005}}};
  block.material = steel;
  block.origin = {0.1, -0.2, 0.3};
  return block;
}

SweptBlock openArc() {
  SweptBlock block = ringBlock();
  block.name = "arc";
  block.stations = {-0.5, false, {{16, 0.02}, {8, 0.05}}};
  return block;
}

Sample sample(int which) {
  Sample s;
  switch (which) {
    case 0:
      s.name = "along x", s.blocks = {lineBlock(SweepKind::alongX)};
      break;
    case 1:
      s.name = "along y", s.blocks = {lineBlock(SweepKind::alongY)};
      break;
    case 2:
      s.name = "closed ring", s.blocks = {ringBlock()};
      break;
    case 3:
      s.name = "open arc", s.blocks = {openArc()};
      break;
    default:
      s.name = "several blocks", s.blocks = {ringBlock(), lineBlock(SweepKind::alongX), openArc()};
  }
  s.size = layOut(s.blocks);
  return s;
}
constexpr int samples = 5;

AlignedVector randomState(const Sample& s, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  AlignedVector u(s.size, 0.0);
  for (const auto& block : s.blocks)
    for (const std::size_t i : unknownsOf(block)) u[i] = value(generator);
  return u;
}

AlignedVector product(const Eigen::SparseMatrix<double>& k, const AlignedVector& u) {
  const Eigen::VectorXd f = k * Eigen::Map<const Eigen::VectorXd>(u.data(), static_cast<Eigen::Index>(u.size()));
  return {f.data(), f.data() + f.size()};
}

double dot(const Sample& s, const AlignedVector& a, const AlignedVector& b) {
  double sum = 0;
  for (const auto& block : s.blocks)
    for (const std::size_t i : unknownsOf(block)) sum += a[i] * b[i];
  return sum;
}

TEST(SweptOperator, IsTheSumOfElementMatrices) {
  for (int which = 0; which < samples; ++which) {
    const Sample s = sample(which);
    const auto k = plainMatrix(s.blocks, s.size);
    const AlignedVector u = randomState(s, 11), expected = product(k, u);
    for (const auto& isa : availableInstructionSets()) {
      const AlignedVector found = applySwept(s.blocks, u, isa);
      double worst = 0;
      for (const auto& block : s.blocks)
        for (const std::size_t i : unknownsOf(block)) worst = std::max(worst, std::abs(found[i] - expected[i]));
      // Round-off: some hundred terms of either sign, and the turn into local components.
      EXPECT_LT(worst, 1e-13 * largest(expected)) << s.name << ", " << isa;
    }
  }
}

TEST(SweptOperator, DiagonalIsThatOfTheElementMatrices) {
  for (int which = 0; which < samples - 1; ++which) {
    const Sample s = sample(which);
    const Eigen::VectorXd expected = plainMatrix(s.blocks, s.size).diagonal();
    const auto found = stiffnessDiagonal(s.blocks[0]);
    for (const std::size_t i : unknownsOf(s.blocks[0]))
      ASSERT_NEAR(found[i], expected[static_cast<Eigen::Index>(i)], 1e-12 * expected.maxCoeff()) << s.name;
  }
}

TEST(SweptOperator, RigidMotionsNeedNoForce) {
  for (int which = 0; which < samples; ++which) {
    const Sample s = sample(which);
    const double stiff = largest(applySwept(s.blocks, randomState(s, 5), ""));
    for (const auto& motion : rigidMotions()) {
      AlignedVector u(s.size, 0.0);
      for (const auto& block : s.blocks) setField(block, motion, u);
      // Forces of a random field of unit size are `stiff`; rigid fields reach 1.5 m.
      EXPECT_LT(largest(applySwept(s.blocks, u, "")), 1e-13 * stiff) << s.name;
    }
  }
}

// Constant strain: forces vanish at inner nodes, and over the whole surface they are those of the constant stress:
// sum of f (x) X = stress times volume (virtual work with a linear field). Stress at each centre is exact.
TEST(SweptOperator, ConstantStrainGivesConstantStress) {
  Eigen::Matrix3d gradient;
  gradient << 1.0, 0.4, -0.3, 0.2, -0.5, 0.7, 0.1, 0.6, 0.8;
  for (int which = 0; which < samples - 1; ++which) {
    const Sample s = sample(which);
    const auto& block = s.blocks[0];
    AlignedVector u(s.size, 0.0);
    setField(
        block, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return gradient * p; }, u);
    Eigen::Matrix<double, 6, 1> strain;
    strain << gradient(0, 0), gradient(1, 1), gradient(2, 2), gradient(0, 1) + gradient(1, 0),
        gradient(1, 2) + gradient(2, 1), gradient(2, 0) + gradient(0, 2);
    const Eigen::Matrix<double, 6, 1> stress = elasticityMatrix(steel) * strain;
    double volume = 0;
    for (const double m : lumpedMass(block)) volume += m / steel.density;
    Eigen::Matrix3d virial = Eigen::Matrix3d::Zero();
    const AlignedVector f = applySwept(s.blocks, u, "");
    const auto& nodes = block.section.nodes;
    double inside = 0;
    for (int n = 0; n < block.nodes; ++n) {
      const bool innerNode = nodes[n][0] > nodes.front()[0] + 1e-9 && nodes[n][0] < nodes.back()[0] - 1e-9 &&
                             nodes[n][1] > nodes.front()[1] + 1e-9 && nodes[n][1] < nodes.back()[1] - 1e-9;
      for (int at = 0; at < block.stationCount; ++at) {
        const Eigen::Vector3d force = displacementAt(block, n, at, f);
        virial += force * nodePosition(block, n, at).transpose();
        if (innerNode && (block.closed || (at > 0 && at < block.intervals))) inside = std::max(inside, force.norm());
      }
    }
    EXPECT_GT(inside, 0) << "there are inner nodes";
    EXPECT_LT(inside, 1e-12 * largest(f)) << s.name;
    Eigen::Matrix3d expected;
    expected << stress[0], stress[3], stress[5], stress[3], stress[1], stress[4], stress[5], stress[4], stress[2];
    EXPECT_LT((virial / volume - expected).norm(), 1e-11 * expected.norm()) << s.name;
    for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q)
      for (const int at : {0, 15, 16, block.intervals - 1})
        ASSERT_LT((centreStress(block, q, at, u) - stress).norm(), 1e-11 * stress.norm()) << s.name;
  }
}

TEST(SweptOperator, IsSymmetricAndPositive) {
  for (int which = 0; which < samples; ++which) {
    const Sample s = sample(which);
    for (unsigned seed = 1; seed < 6; ++seed) {
      const AlignedVector a = randomState(s, seed), b = randomState(s, seed + 100);
      const AlignedVector ka = applySwept(s.blocks, a, ""), kb = applySwept(s.blocks, b, "");
      const double aka = dot(s, a, ka), bkb = dot(s, b, kb);
      EXPECT_GT(aka, 0) << s.name;
      EXPECT_NEAR(dot(s, b, ka), dot(s, a, kb), 1e-13 * std::sqrt(aka * bkb)) << s.name;
    }
  }
}

// The cuts between threads move, the bits do not.
TEST(SweptOperator, DoesNotDependOnThePartition) {
  for (int which = 0; which < samples; ++which) {
    const Sample s = sample(which);
    const AlignedVector u = randomState(s, 3);
    for (const auto& isa : availableInstructionSets()) {
      for (const auto precision : {Precision::doubleInside, Precision::singleInside}) {
        const AlignedVector one = applySwept(s.blocks, u, isa, 1, precision);
        for (const int parts : {2, 3, 5})
          EXPECT_EQ(applySwept(s.blocks, u, isa, parts, precision), one) << s.name << ", " << isa;
      }
    }
  }
}

// Forces in single precision against those in double: sums of some 160 products of numbers that are rounded to 6e-8 of
// themselves, so 2e-6 of the largest force is ample. Fields that strain by 1e-3 or so; a translation of a metre and a
// turn by a tenth of a radian besides, each a thousand times the displacements that strain and more, change nothing:
// they are taken off before anything is rounded.
TEST(SweptOperator, SinglePrecisionInsideAgreesAndDoesNotSeeRigidMotions) {
  for (int which = 0; which < samples; ++which) {
    const Sample s = sample(which);
    AlignedVector small(s.size, 0.0), moved(s.size, 0.0);
    for (const auto& block : s.blocks) {
      const auto strains = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return 1e-3 * Eigen::Vector3d(p[0] * p[2] + 0.1 * p[1], p[1] * p[0] - 0.1 * p[2], p[2] - p[0] * p[1]);
      };
      setField(block, strains, small);
      setField(
          block,
          [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
            return strains(p) + Eigen::Vector3d(0.7, -0.3, 0.6) + Eigen::Vector3d(0.06, -0.1, 0.04).cross(p);
          },
          moved);
    }
    for (const auto& isa : availableInstructionSets()) {
      const AlignedVector expected = applySwept(s.blocks, small, isa);
      for (const auto* u : {&small, &moved}) {
        const AlignedVector found = applySwept(s.blocks, *u, isa, 2, Precision::singleInside);
        double maximum = 0;
        for (std::size_t i = 0; i < found.size(); ++i) maximum = std::max(maximum, std::abs(found[i] - expected[i]));
        EXPECT_GT(maximum, 0) << "it is single precision";
        EXPECT_LT(maximum, 2e-6 * largest(expected)) << s.name << ", " << isa;
      }
    }
  }
}

// What is too small to be held in full (1e-42 in single precision, 1e-310 in double) counts as zero: some processors
// take a hundred times as long for it. Outside the kernels such numbers stay what they are.
TEST(SweptOperator, TinyNumbersCountAsZeroWithinTheKernelsOnly) {
  const Sample s = sample(4);
  for (const auto& [precision, size] : {std::pair{Precision::singleInside, 1e-42}, {Precision::doubleInside, 1e-310}}) {
    AlignedVector u = randomState(s, 5);
    for (double& value : u) value *= size;
    for (const auto& isa : availableInstructionSets())
      EXPECT_EQ(largest(applySwept(s.blocks, u, isa, 2, precision)), 0) << isa;
  }
  volatile double tiny = 1e-310;
  EXPECT_GT(0.5 * tiny, 0);
}

TEST(SweptBlock, MassIsThatOfTheSolid) {
  const Sample bar = sample(0);
  double sum = 0;
  for (const double m : lumpedMass(bar.blocks[0])) sum += m;
  const double length = 16 * 0.0013 + 8 * 0.0026 + 40 * 0.005;
  EXPECT_NEAR(sum, steel.density * 0.06 * 0.035 * length, 1e-12 * sum);
  // A ring of chords: each sector is a prism over triangles, r^2 sin(angle) / 2 instead of r^2 angle / 2.
  const Sample ring = sample(2);
  sum = 0;
  for (const double m : lumpedMass(ring.blocks[0])) sum += m;
  double area = 0;
  for (const auto& run : ring.blocks[0].stations.runs)
    area += run.count * std::sin(run.length) / 2 * (0.40 * 0.40 - 0.30 * 0.30);
  EXPECT_NEAR(sum, steel.density * area * 0.07, 1e-12 * sum);
}

TEST(SweptBlock, RefusesRunsThatDoNotFillVectors) {
  SweptBlock block = lineBlock(SweepKind::alongX);
  block.stations.runs[0].count = 12;
  EXPECT_THROW(prepareBlock(block), std::invalid_argument);
}

TEST(SweptKernel, RefusesUnknownInstructionSets) { EXPECT_THROW(kernelsFor("mmx"), std::invalid_argument); }

}  // namespace
}  // namespace squat::elasticity
