#include "elasticity/SweptSamples.h"

#include <algorithm>
#include <cmath>

#include "elasticity/SweptWork.h"

namespace squat::elasticity {

std::vector<double> evenly(double from, double to, int n) {
  std::vector<double> values;
  for (int i = 0; i <= n; ++i) values.push_back(from + (to - from) * i / n);
  return values;
}

geometry::SectionMesh gridSection(const std::vector<double>& b, const std::vector<double>& c, double skew) {
  geometry::SectionMesh mesh;
  const int n = static_cast<int>(b.size()), m = static_cast<int>(c.size());
  double step = b.back() - b.front();
  for (int i = 1; i < n; ++i) step = std::min(step, b[i] - b[i - 1]);
  for (int j = 1; j < m; ++j) step = std::min(step, c[j] - c[j - 1]);
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const bool inner = i > 0 && j > 0 && i + 1 < n && j + 1 < m;
      const double move = inner ? skew * step : 0;
      mesh.nodes.push_back({b[i] + move * std::sin(3.0 * i + 5.0 * j), c[j] + move * std::cos(7.0 * i + 2.0 * j)});
    }
  for (int j = 0; j + 1 < m; ++j)
    for (int i = 0; i + 1 < n; ++i)
      mesh.quads.push_back({j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
  return mesh;
}

SweptBlock ringBlock() {
  SweptBlock block;
  block.name = "ring";
  block.kind = SweepKind::aroundAxis;
  block.section = gridSection({0.30, 0.34, 0.36, 0.40}, {-0.03, 0.0, 0.04}, 0.25);
  const double full = 2 * std::acos(-1.0), fine = 0.02;
  block.stations = {0.3, true, {{40, fine}, {24, (full - 40 * fine) / 24}}};
  block.material = steel;
  block.origin = {1.0, 0.5, 0.46};
  return block;
}

std::size_t layOut(std::vector<SweptBlock>& blocks) {
  std::size_t size = 0;
  for (auto& block : blocks) {
    prepareBlock(block);
    block.offset = size;
    size += block.size();
  }
  return size;
}

void setField(const SweptBlock& block, const Field& field, AlignedVector& state) {
  for (int n = 0; n < block.nodes; ++n)
    for (int s = 0; s <= block.intervals; ++s) {
      const Eigen::Vector3d local =
          localBasis(block, block.positions[s]).transpose() * field(nodePosition(block, n, s));
      for (int c = 0; c < 3; ++c) state[block.index(n, c, s)] = local[c];
    }
}

Eigen::Vector3d displacementAt(const SweptBlock& block, int node, int station, const AlignedVector& state) {
  const Eigen::Vector3d local(state[block.index(node, 0, station)], state[block.index(node, 1, station)],
                              state[block.index(node, 2, station)]);
  return localBasis(block, block.positions[station]) * local;
}

AlignedVector applySwept(const std::vector<SweptBlock>& blocks, const AlignedVector& u, const std::string& isa,
                         int parts, Precision precision) {
  std::vector<int> all;
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b) all.push_back(b);
  AlignedVector source = u, result(u.size(), 0.0);
  refreshGhosts(blocks, source.data());
  const auto kernels = kernelsFor(isa, precision);
  for (const auto& segments : partition(blocks, all, parts)) {
    KernelScratch scratch(blocks);
    applySegments(segments, blocks, kernels, source.data(), result.data(), scratch);
  }
  return result;
}

void passToMasters(const SweptTie& tie, const std::vector<SweptBlock>& blocks, const AlignedVector& from,
                   AlignedVector& to, const std::vector<int>& cuts) {
  const auto &slave = blocks[tie.slaveBlock], &master = blocks[tie.masterBlock];
  AlignedVector workspace(tieWorkspace(tie));
  std::vector<int> ends = cuts;
  ends.push_back(master.stationCount);
  int first = 0;
  for (const int last : ends) {
    transferForces(
        tie, 1.0, [&](int i, int c) { return slave.line(from.data(), tie.slaveNodes[i], c); },
        [&](int node, int c) { return master.line(to.data(), node, c); }, workspace.data(), first, last,
        slaveSpans(tie, first, last));
    first = last;
  }
}

Eigen::SparseMatrix<double> plainMatrix(const std::vector<SweptBlock>& blocks, std::size_t size) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& block : blocks)
    for (int s = 0; s < block.intervals; ++s) {
      const int right = block.closed && s + 1 == block.intervals ? 0 : s + 1;
      const Eigen::Matrix3d bases[2] = {localBasis(block, block.positions[s]),
                                        localBasis(block, block.positions[s + 1])};
      for (const auto& quad : block.section.quads) {
        Corners corners;
        Matrix24 turn = Matrix24::Zero();
        std::size_t index[24];
        for (int i = 0; i < 8; ++i) {
          corners[i] = nodePosition(block, quad[i % 4], s + i / 4);
          turn.block<3, 3>(3 * i, 3 * i) = bases[i / 4];
          for (int c = 0; c < 3; ++c) index[3 * i + c] = block.index(quad[i % 4], c, i < 4 ? s : right);
        }
        const Matrix24 k = turn.transpose() * hexahedronStiffness(corners, block.material) * turn;
        for (int i = 0; i < 24; ++i)
          for (int j = 0; j < 24; ++j)
            entries.emplace_back(static_cast<int>(index[i]), static_cast<int>(index[j]), k(i, j));
      }
    }
  Eigen::SparseMatrix<double> matrix(static_cast<int>(size), static_cast<int>(size));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<std::size_t> unknownsOf(const SweptBlock& block) {
  std::vector<std::size_t> unknowns;
  for (int n = 0; n < block.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      for (int s = 0; s < block.stationCount; ++s) unknowns.push_back(block.index(n, c, s));
  return unknowns;
}

Eigen::Matrix<double, 6, 1> centreStress(const SweptBlock& block, int quad, int interval, const AlignedVector& state) {
  const int right = block.closed && interval + 1 == block.intervals ? 0 : interval + 1;
  Corners corners;
  Eigen::Matrix<double, 24, 1> u;
  for (int i = 0; i < 8; ++i) {
    const int node = block.section.quads[quad][i % 4];
    corners[i] = nodePosition(block, node, interval + i / 4);
    u.segment<3>(3 * i) = displacementAt(block, node, i < 4 ? interval : right, state);
  }
  return elasticityMatrix(block.material) * (centreStrain(corners) * u);
}

std::vector<Field> rigidMotions() {
  std::vector<Field> motions;
  for (int c = 0; c < 3; ++c) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(c);
    motions.push_back([axis](const Eigen::Vector3d&) { return axis; });
    motions.push_back([axis](const Eigen::Vector3d& p) -> Eigen::Vector3d { return axis.cross(p); });
  }
  return motions;
}

double largest(const AlignedVector& values) {
  double maximum = 0;
  for (const double v : values) maximum = std::max(maximum, std::abs(v));
  return maximum;
}

}  // namespace squat::elasticity
