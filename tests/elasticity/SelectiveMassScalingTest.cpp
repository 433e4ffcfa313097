// More inertia for short waves: what the step does against the definition, a dense projection written out here; what
// must be left alone; and the bound that contact's added mass relies on.
#include "elasticity/SelectiveMassScaling.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>
#include <tuple>

#include "elasticity/SectionClusters.h"
#include "elasticity/SweptSamples.h"
#include "elasticity/SweptWork.h"

namespace squat::elasticity {
namespace {

// A ring and a bar, each with clusters, nodes on their own and one that is in none; runs of short and long intervals.
std::vector<SweptBlock> filteredBlocks() {
  SweptBlock ring = ringBlock(), bar;
  const double full = 2 * std::acos(-1.0), fine = 0.02;
  ring.stations = {0.3, true, {{72, fine}, {24, (full - 72 * fine) / 24}}};
  ring.clusters = {{0, 1, 4, 5}, {2, 3, 6, 7}, {8, 9, 10}};
  ring.shortLength = 0.03;
  bar.name = "bar", bar.kind = SweepKind::alongX;
  bar.section = gridSection({-0.03, -0.01, 0.005, 0.03}, {0, 0.02, 0.035}, 0.25);
  bar.stations = {-0.2, false, {{16, 0.0013}, {8, 0.0026}, {40, 0.005}}};
  bar.material = steel;
  bar.clusters = {{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10}, {11}};
  bar.shortLength = 0.003;
  return {ring, bar};
}

using Locations = std::vector<std::pair<int, int>>;  // node, station

// Blocks of nodes that are filtered together, and whether along the sweep as well.
std::vector<std::pair<Locations, bool>> blocksOf(const SweptBlock& block) {
  std::vector<std::pair<Locations, bool>> all;
  for (const auto& cluster : block.clusters)
    for (int s = 0; s < block.stationCount;) {
      const bool along = s < block.intervals && block.stations.runs[block.runOf(s)].length <= block.shortLength;
      // Sixteen where they begin at a multiple of 16 and are of one run, else eight.
      const bool wide = along && s % 16 == 0 && s + 16 <= block.runIntervals[block.runOf(s)][1];
      const int end = wide ? s + 16 : along ? s + 8 : s + 1;
      Locations locations;
      for (const int node : cluster)
        for (int k = s; k < end; ++k) locations.emplace_back(node, k);
      all.emplace_back(locations, along);
      s = end;
    }
  return all;
}

// Fields that are kept: products of (1, p, q) across and (1, station) along.
Eigen::MatrixXd keptOf(const SweptBlock& block, const Locations& locations, bool along) {
  Eigen::MatrixXd fields(static_cast<Eigen::Index>(locations.size()), along ? 6 : 3);
  for (Eigen::Index i = 0; i < fields.rows(); ++i) {
    const auto [node, s] = locations[i];
    const auto& p = block.section.nodes[node];
    const Eigen::RowVector3d across(1, 1e2 * p[0], 1e2 * p[1]);
    fields.row(i).head<3>() = across;
    if (along) fields.row(i).tail<3>() = across * (s - locations.front().second);
  }
  return fields;
}

// share 1 + (1 - share) P, P orthogonal in the masses.
Eigen::MatrixXd filterOf(const Eigen::MatrixXd& fields, const Eigen::VectorXd& mass) {
  const Eigen::VectorXd root = mass.cwiseSqrt();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(root.asDiagonal() * fields);
  qr.setThreshold(1e-9);
  const Eigen::MatrixXd q = Eigen::MatrixXd(qr.householderQ()).leftCols(qr.rank());
  const Eigen::Index n = mass.size();
  return root.cwiseInverse().asDiagonal() * (0.1 * Eigen::MatrixXd::Identity(n, n) + 0.9 * q * q.transpose()) *
         root.asDiagonal();
}

AlignedVector byDefinition(const SweptBlock& block, const AlignedVector& accelerations,
                           const std::vector<double>& mass) {
  AlignedVector result = accelerations;
  for (const auto& [locations, along] : blocksOf(block)) {
    Eigen::VectorXd own(static_cast<Eigen::Index>(locations.size()));
    for (Eigen::Index i = 0; i < own.size(); ++i)
      own[i] = mass[locations[i].first * block.stride + locations[i].second];
    const Eigen::MatrixXd filter = filterOf(keptOf(block, locations, along), own);
    for (int c = 0; c < 3; ++c) {
      Eigen::VectorXd a(own.size());
      for (Eigen::Index i = 0; i < own.size(); ++i)
        a[i] = accelerations[block.index(locations[i].first, c, locations[i].second)];
      a = (filter * a).eval();
      for (Eigen::Index i = 0; i < own.size(); ++i)
        result[block.index(locations[i].first, c, locations[i].second)] = a[i];
    }
  }
  return result;
}

struct MassSample {
  std::vector<SweptBlock> blocks = filteredBlocks();
  std::size_t size = layOut(blocks);
  AlignedVector displaced = AlignedVector(size, 0.0);
  std::vector<std::vector<double>> mass;  // per block, in lines
  // As under closed contact, per block: whose filter, and what KernelFilter points to.
  std::vector<std::vector<int>> ownFilter;
  std::vector<std::vector<std::vector<double>>> values;
  std::vector<std::vector<std::vector<float>>> singleValues;

  MassSample() {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> value(-1e-4, 1e-4);
    for (const auto& block : blocks) {
      for (const std::size_t i : unknownsOf(block)) displaced[i] = value(generator);
      mass.push_back(lumpedMass(block));
      ownFilter.emplace_back(block.inertia.clusters.size() * static_cast<std::size_t>(block.intervals / stationUnit),
                             -1);
    }
    values.resize(blocks.size()), singleValues.resize(blocks.size());
    refreshGhosts(blocks, displaced.data());
  }

  // Some nodes of every cluster on these stations become up to ten times as heavy.
  void grow(std::size_t b, int first, int stations) {
    const auto& block = blocks[b];
    for (std::size_t k = 0; k < block.inertia.clusters.size(); ++k) {
      const auto& locations = block.inertia.clusters[k];
      const std::vector<int> nodes(block.order.members.begin() + locations.first,
                                   block.order.members.begin() + locations.end);
      std::vector<double> grown;
      for (const int node : nodes)
        for (int s = first; s < first + stations; ++s) {
          double& m = mass[b][static_cast<std::size_t>(node) * block.stride + static_cast<std::size_t>(s)];
          if ((node + s) % 3 == 0) m *= 2 + (node * 7 + s * 3) % 9;
          grown.push_back(m);
        }
      auto& own = values[b].emplace_back();
      blockFilter(block, nodes, stations, grown, own);
      singleValues[b].emplace_back(own.begin(), own.end());
      ownFilter[b][k * static_cast<std::size_t>(block.intervals / stationUnit) +
                   static_cast<std::size_t>(first / stationUnit)] = static_cast<int>(values[b].size()) - 1;
    }
  }

  std::vector<KernelFilter> filters(std::size_t b) const {
    std::vector<KernelFilter> all;
    for (std::size_t i = 0; i < values[b].size(); ++i) all.push_back({values[b][i].data(), singleValues[b][i].data()});
    return all;
  }

  AlignedVector inverseMass(std::size_t b) const {
    auto inverse = mass[b];
    for (double& m : inverse) m = m > 0 ? 1 / m : 0;
    return inChunks(blocks[b], inverse.data());
  }

  AlignedVector bareAccelerations() const {
    AlignedVector a = applySwept(blocks, displaced, availableInstructionSets().front());
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (const std::size_t i : unknownsOf(blocks[b])) {
        const auto at = blocks[b].unknownAt(i);
        a[i] /= -mass[b][at.node * blocks[b].stride + at.station];
      }
    return a;
  }
};

// Plain accelerations within round-off of the definition, masses of eight stations included that a coarser run adjoins.
TEST(SelectiveMassScaling, IsTheProjectionInTheMasses) {
  const MassSample sample;
  const AlignedVector bare = sample.bareAccelerations();
  AlignedVector filtered = bare;
  for (const auto& block : sample.blocks) {
    slowShortWaves(block, filtered.data() + block.offset);
    const AlignedVector expected = byDefinition(block, bare, lumpedMass(block));
    double maximum = 0, different = 0, size = 0;
    for (const std::size_t i : unknownsOf(block)) {
      size = std::max(size, std::abs(bare[i]));
      maximum = std::max(maximum, std::abs(filtered[i] - expected[i]));
      different = std::max(different, std::abs(filtered[i] - bare[i]));
    }
    EXPECT_LT(maximum, 1e-11 * size) << block.name;
    EXPECT_GT(different, 0.1 * size) << "it does something";
  }
}

// What one block's step works with; `even`: masses of the section alone as one number a node, and along a line one body
// acceleration for all stations.
struct BlockData {
  AlignedVector inverseMass, bodyAcceleration;
  std::vector<double> mask, evenInverse;
  std::vector<int> line;
  std::vector<unsigned char> slave;
  std::vector<KernelFilter> filters;

  BlockData(const MassSample& sample, std::size_t b, const std::array<double, 3>& pushed)
      : inverseMass(sample.inverseMass(b)), filters(sample.filters(b)) {
    const auto& block = sample.blocks[b];
    for (const double push : pushed) bodyAcceleration.insert(bodyAcceleration.end(), block.stride, push);
    mask.assign(block.lines(), 1.0), line.assign(block.nodes, -1), slave.assign(block.nodes, 0);
    auto inverse = sample.mass[b];
    for (double& m : inverse) m = m > 0 ? 1 / m : 0;
    evenInverse = evenInverseMass(block, inverse.data(), line.data());
  }
  BlockStep step(const MassSample& sample, std::size_t b, const KernelSet& kernels, bool even) const {
    BlockStep with;
    with.kernels = &kernels;
    with.inverseMass = inverseMass.data(), with.freeMask = mask.data(), with.lineOfNode = line.data();
    with.slave = slave.data(), with.acceleration = bodyAcceleration.data();
    with.ownFilter = sample.ownFilter[b].data(), with.filters = filters.data();
    if (even) with.evenInverse = evenInverse.data();
    const auto& block = sample.blocks[b];
    if (even && block.kind != SweepKind::aroundAxis) {
      for (int c = 0; c < 3; ++c) with.evenAcceleration[c] = bodyAcceleration[c * block.stride];
      with.acceleration = nullptr, with.freeMask = nullptr;
    }
    return with;
  }
};

// One step from rest: velocity over step is the acceleration. Double: round-off. Single: forces and filter are rounded
// to 6e-8, and the forces of neighbouring nodes cancel by a factor of some hundred.
void expectTheStepByDefinition(const MassSample& sample) {
  AlignedVector expected = sample.bareAccelerations();
  const double size = largest(expected);
  std::vector<BlockData> data;
  for (std::size_t b = 0; b < sample.blocks.size(); ++b) {
    const auto& block = sample.blocks[b];
    expected = byDefinition(block, expected, sample.mass[b]);
    const std::array<double, 3> pushed{0.3 * size, -0.5 * size, 0.2 * size};
    data.emplace_back(sample, b, pushed);
    for (const std::size_t i : unknownsOf(block)) expected[i] += pushed[block.unknownAt(i).component];
  }
  for (const auto& isa : availableInstructionSets())
    for (const auto precision : {Precision::doubleInside, Precision::singleInside})
      for (const auto& [parts, even] : {std::pair{1, false}, {3, true}, {5, false}, {1, true}}) {
        const auto kernels = kernelsFor(isa, precision);
        AlignedVector velocity(sample.size, 0.0), target = sample.displaced;
        std::vector<BlockStep> steps;
        for (std::size_t b = 0; b < sample.blocks.size(); ++b) steps.push_back(data[b].step(sample, b, kernels, even));
        KernelScratch scratch(sample.blocks);
        constexpr double step = 1e-7;
        for (const auto& segments : partition(sample.blocks, {0, 1}, parts))
          advanceSegments(segments, sample.blocks, steps, step, sample.displaced.data(), target.data(), velocity.data(),
                          scratch);
        double maximum = 0;
        for (const auto& block : sample.blocks)
          for (const std::size_t i : unknownsOf(block))
            maximum = std::max(maximum, std::abs(velocity[i] / step - expected[i]));
        EXPECT_LT(maximum, (precision == Precision::doubleInside ? 1e-10 : 2e-5) * size)
            << isa << ", " << parts << " parts" << (even ? ", even" : "");
      }
}

// Masses of the section are one number a node on runs of different length, around the axis too; a node that has grown
// anywhere, or has a line, has its own.
TEST(SelectiveMassScaling, EvenMassesAreThoseOfTheSectionAlone) {
  MassSample sample;
  sample.grow(0, 32, 16);
  for (std::size_t b = 0; b < sample.blocks.size(); ++b) {
    const auto& block = sample.blocks[b];
    const auto bare = lumpedMass(block);
    auto inverse = sample.mass[b];
    for (double& m : inverse) m = m > 0 ? 1 / m : 0;
    std::vector<int> line(block.nodes, -1);
    line[1] = 4;
    const auto even = evenInverseMass(block, inverse.data(), line.data());
    int grown = 0;
    for (int n = 0; n < block.nodes; ++n) {
      const double* own = sample.mass[b].data() + n * block.stride;
      const bool isBare = std::equal(own, own + block.stationCount, bare.data() + n * block.stride);
      grown += !isBare;
      EXPECT_EQ(even[n] != 0, isBare && n != 1) << block.name << ", node " << n;
      // Products of two rounded numbers.
      for (int s = 0; even[n] != 0 && s < block.stationCount; ++s)
        EXPECT_NEAR(own[s] * even[n] / block.stationMass[s], 1, 1e-12);
    }
    EXPECT_EQ(grown > 0, b == 0);
  }
}

TEST(SelectiveMassScaling, TheStepDoesTheSameOnAllInstructionSets) { expectTheStepByDefinition({}); }

// Stations whose masses have grown, 16 and eight of them, first in their chunk and within it, in all clusters: of
// eight, four and three nodes, and one by itself.
TEST(SelectiveMassScaling, TheStepFiltersHeavierStationsInTheirOwnMasses) {
  MassSample sample;
  const AlignedVector before = byDefinition(sample.blocks[1], sample.bareAccelerations(), sample.mass[1]);
  sample.grow(0, 32, 16), sample.grow(0, 48, 16), sample.grow(0, 64, 8);
  sample.grow(1, 0, 16), sample.grow(1, 16, 8);
  const AlignedVector after = byDefinition(sample.blocks[1], sample.bareAccelerations(), sample.mass[1]);
  const std::size_t at = sample.blocks[1].index(0, 2, 18);
  EXPECT_GT(std::abs(after[at] - before[at]), 0.05 * std::abs(before[at])) << "it is felt";
  expectTheStepByDefinition(sample);
}

// Resultant and moments: what the masses gain in momentum, and in moment of momentum about all axes, is what the bare
// accelerations would have given. Along a line exactly; the fields that are kept in the ring's turning basis are
// constant and linear there, rigid motions only nearly so, its turning about the axis exactly.
TEST(SelectiveMassScaling, KeepsMomentumAndItsMoments) {
  const MassSample sample;
  const AlignedVector bare = sample.bareAccelerations();
  AlignedVector filtered = bare;
  for (const auto& block : sample.blocks) slowShortWaves(block, filtered.data() + block.offset);
  for (const auto& block : sample.blocks) {
    const auto mass = lumpedMass(block);
    const auto momentum = [&](const AlignedVector& a) {
      Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
      double size = 0;
      for (int n = 0; n < block.nodes; ++n)
        for (int s = 0; s < block.stationCount; ++s) {
          const Eigen::Vector3d p = mass[n * block.stride + s] * displacementAt(block, n, s, a);
          const Eigen::Vector3d location = nodePosition(block, n, s) - block.origin;
          sum.head<3>() += p, sum.tail<3>() += location.cross(p);
          size += p.norm();
        }
      return std::pair{sum, size};
    };
    const auto [before, size] = momentum(bare);
    const auto [after, sizeAfter] = momentum(filtered);
    EXPECT_GT(size, 0);
    if (block.kind == SweepKind::alongX)
      EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-12 * size);
    else
      EXPECT_LT(std::abs(after[4] - before[4]), 1e-12 * size);
  }
}

// Blocks whose masses grow by any D: the effective mass grows by D at least. M_e = M F^-1, dense, masses and D at
// random.
TEST(SelectiveMassScaling, AddedMassIsFeltInFullByEveryMotion) {
  const MassSample sample;
  const auto& block = sample.blocks[1];
  const auto& cluster = block.clusters[0];
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> value(0, 1);
  constexpr int stations = 16;
  const auto count = static_cast<Eigen::Index>(stations * cluster.size());
  Eigen::VectorXd mass(count), added(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    mass[i] = 1e-3 * (0.2 + value(generator));
    added[i] = value(generator) < 0.3 ? 1e-2 * value(generator) : 0;
  }
  const auto effective = [&](const Eigen::VectorXd& m) {
    std::vector<double> values;
    blockFilter(block, cluster, stations, {m.data(), m.data() + count}, values);
    const Eigen::Map<const Eigen::MatrixXd> weights(values.data(), count, 6),
        fields(values.data() + 6 * count, count, 6);
    const Eigen::MatrixXd filter = 0.1 * Eigen::MatrixXd::Identity(count, count) + fields * weights.transpose();
    Locations locations;
    for (const int node : cluster)
      for (int s = 0; s < stations; ++s) locations.emplace_back(node, s);
    const Eigen::MatrixXd expected = filterOf(keptOf(block, locations, true), m);
    EXPECT_LT((filter - expected).cwiseAbs().maxCoeff(), 1e-9);
    return Eigen::MatrixXd(m.asDiagonal() * filter.inverse());
  };
  Eigen::MatrixXd gain = effective(mass + added) - effective(mass);
  gain.diagonal() -= added;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (gain + gain.transpose()));
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-9 * mass.maxCoeff());
  EXPECT_GT(eigen.eigenvalues().maxCoeff(), 0);
}

// The search takes every node that may join once, leaves the others, and finds the same again. That it pays is held by
// StableStep.CoversTheBareRail.
TEST(SelectiveMassScaling, ClustersHoldEveryNodeOnce) {
  SweptBlock block;
  block.name = "bar", block.kind = SweepKind::alongX;
  block.section = gridSection(evenly(-0.01, 0.01, 9), evenly(0, 0.012, 6), 0);
  block.stations = {0, false, {{16, 0.002}}};
  block.material = steel;
  prepareBlock(block);
  const auto mayJoin = [&](int n) { return block.section.nodes[n][1] > 1e-6; };
  const auto clusters = sectionClusters(block, mayJoin);
  std::vector<int> seen(static_cast<std::size_t>(block.nodes), 0);
  std::size_t largestOne = 0;
  for (const auto& cluster : clusters) {
    largestOne = std::max(largestOne, cluster.size());
    EXPECT_LE(cluster.size(), static_cast<std::size_t>(maximumRows));
    for (const int n : cluster) ++seen[n];
  }
  for (int n = 0; n < block.nodes; ++n) EXPECT_EQ(seen[n], mayJoin(n) ? 1 : 0);
  EXPECT_GT(largestOne, 5U);
  EXPECT_EQ(sectionClusters(block, mayJoin), clusters);
}

}  // namespace
}  // namespace squat::elasticity
