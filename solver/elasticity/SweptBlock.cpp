#include "elasticity/SweptBlock.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/ElementaryFunctions.h"

namespace squat::elasticity {

namespace {

void findPairs(const geometry::SectionMesh& section, std::vector<int>& rowStart, std::vector<int>& columns) {
  std::vector<std::set<int>> neighbours(section.nodes.size());
  for (const auto& quad : section.quads)
    for (const int i : quad)
      for (const int j : quad) neighbours[i].insert(j);
  rowStart.assign(1, 0);
  columns.clear();
  for (const auto& row : neighbours) {
    columns.insert(columns.end(), row.begin(), row.end());
    rowStart.push_back(static_cast<int>(columns.size()));
  }
}

int pairIndex(const SweptBlock& block, int i, int j) {
  for (int p = block.rowStart[i]; p < block.rowStart[i + 1]; ++p)
    if (block.columns[p] == j) return p;
  throw std::logic_error("section nodes do not share a quad");
}

// Adds one element's matrix to the assembled S and T blocks. R and L: right and left station.
void addElement(const SweptBlock& block, const std::array<int, 4>& quad, const Matrix24& k, std::vector<double>& out) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Eigen::Matrix3d ll = k.block<3, 3>(3 * i, 3 * j), lr = k.block<3, 3>(3 * i, 12 + 3 * j);
      const Eigen::Matrix3d rl = k.block<3, 3>(12 + 3 * i, 3 * j), rr = k.block<3, 3>(12 + 3 * i, 12 + 3 * j);
      const Eigen::Matrix3d sumOfSums = rr + lr + rl + ll, sumOfDifferences = rr + lr - rl - ll;
      const Eigen::Matrix3d differenceOfSums = rr - lr + rl - ll, differenceOfDifferences = rr - lr - rl + ll;
      double* pair = out.data() + 18 * pairIndex(block, quad[i], quad[j]);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          // S acts on (d_a, s_b, s_c) and yields (difference_a, sum_b, sum_c); T on (s_a, d_b, d_c) likewise.
          const bool rowA = row == 0, columnA = column == 0;
          const Eigen::Matrix3d& forS =
              rowA ? (columnA ? differenceOfDifferences : differenceOfSums) : (columnA ? sumOfDifferences : sumOfSums);
          const Eigen::Matrix3d& forT =
              rowA ? (columnA ? sumOfSums : sumOfDifferences) : (columnA ? differenceOfSums : differenceOfDifferences);
          pair[3 * row + column] += 0.25 * forS(row, column);
          pair[9 + 3 * row + column] += 0.25 * forT(row, column);
        }
      }
    }
  }
}

// The section nodes next to the centre of its quads' area and farthest from it.
std::array<int, 2> middleAndFar(const geometry::SectionMesh& section) {
  double area = 0, b = 0, c = 0;
  for (const auto& quad : section.quads)
    for (int k = 0; k < 4; ++k) {
      const auto &p = section.nodes[quad[k]], &q = section.nodes[quad[(k + 1) % 4]];
      const double cross = p[0] * q[1] - q[0] * p[1];
      area += cross / 2, b += cross * (p[0] + q[0]) / 6, c += cross * (p[1] + q[1]) / 6;
    }
  const auto away = [&](const geometry::Point2& p) { return elementary::hypot(p[0] - b / area, p[1] - c / area); };
  const auto [minimum, maximum] = std::minmax_element(section.nodes.begin(), section.nodes.end(),
                                                      [&](const auto& p, const auto& q) { return away(p) < away(q); });
  return {static_cast<int>(minimum - section.nodes.begin()), static_cast<int>(maximum - section.nodes.begin())};
}

AlignedVector stationMass(const SweptBlock& block) {
  AlignedVector mass(block.stride, 0.0);
  for (std::size_t r = 0; r < block.runIntervals.size(); ++r)
    for (int s = block.runIntervals[r][0]; s < block.runIntervals[r][1]; ++s) {
      const double half = 0.5 * massOfInterval(block, block.stations.runs[r].length);
      mass[s] += half, mass[block.closed && s + 1 == block.intervals ? 0 : s + 1] += half;
    }
  return mass;
}

}  // namespace

int SweptBlock::runOf(int interval) const {
  for (std::size_t r = 0; r < runIntervals.size(); ++r)
    if (interval < runIntervals[r][1]) return static_cast<int>(r);
  return static_cast<int>(runIntervals.size()) - 1;
}

void numberAsVisited(geometry::SectionMesh& section, std::vector<std::vector<int>>& clusters) {
  std::vector<int> rowStart, columns;
  findPairs(section, rowStart, columns);
  const auto order = sectionOrder(rowStart, columns, clusters).nodes;
  std::vector<int> newIndex(order.size());
  auto nodes = section.nodes;
  for (std::size_t i = 0; i < order.size(); ++i)
    newIndex[order[i]] = static_cast<int>(i), nodes[i] = section.nodes[order[i]];
  section.nodes = std::move(nodes);
  for (auto& quad : section.quads)
    for (int& node : quad) node = newIndex[node];
  for (auto& cluster : clusters) {
    for (int& node : cluster) node = newIndex[node];
    std::sort(cluster.begin(), cluster.end());
  }
}

void prepareBlock(SweptBlock& block) {
  block.nodes = static_cast<int>(block.section.nodes.size());
  block.intervals = block.stations.intervals();
  block.stationCount = block.stations.count();
  block.closed = block.stations.closed;
  block.positions = block.stations.positions();
  block.cosines.clear(), block.sines.clear();
  for (const double at : block.positions)
    if (block.kind == SweepKind::aroundAxis)
      block.cosines.push_back(elementary::cos(at)), block.sines.push_back(elementary::sin(at));
  block.stride = (static_cast<std::size_t>(block.intervals) + 1 + 7) / 8 * 8;
  findPairs(block.section, block.rowStart, block.columns);
  block.order = sectionOrder(block.rowStart, block.columns, block.clusters);
  block.coefficients.clear();
  block.rowCoefficients.clear();
  block.singleCoefficients.clear();
  block.runIntervals.clear();
  int first = 0;
  for (const auto& run : block.stations.runs) {
    if (run.count % 8 != 0) throw std::invalid_argument(block.name + ": a run of stations is no multiple of 8");
    std::vector<double> matrix(18 * block.columns.size(), 0.0);
    for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q)
      addElement(block, block.section.quads[q], elementStiffness(block, q, run.length), matrix);
    std::vector<double>& rows = block.rowCoefficients.emplace_back();
    for (const int pair : block.order.pairs)
      rows.insert(rows.end(), matrix.begin() + 18 * pair, matrix.begin() + 18 * (pair + 1));
    block.singleCoefficients.emplace_back(rows.begin(), rows.end());
    block.coefficients.push_back(std::move(matrix));
    block.runIntervals.push_back({first, first + run.count});
    first += run.count;
  }
  const auto [middle, far] = middleAndFar(block.section);
  block.middle = middle, block.far = far;
  block.lowest = std::min_element(block.section.nodes.begin(), block.section.nodes.end())->front();
  block.stationMass = stationMass(block);
  block.inertia = selectiveMassScaling(block);
}

double massOfInterval(const SweptBlock& block, double length) {
  return block.kind == SweepKind::aroundAxis ? elementary::sin(length) : length;
}

Eigen::Matrix3d localBasis(const SweptBlock& block, double position) {
  Eigen::Matrix3d basis;
  switch (block.kind) {
    case SweepKind::alongX:
      basis << 1, 0, 0, 0, elementary::cos(block.lean), -elementary::sin(block.lean), 0, elementary::sin(block.lean),
          elementary::cos(block.lean);
      break;
    case SweepKind::alongY:
      basis << 0, 0, 1, 1, 0, 0, 0, 1, 0;
      break;
    case SweepKind::aroundAxis: {
      const double c = elementary::cos(position), s = elementary::sin(position);
      basis << c, s, 0, 0, 0, 1, s, -c, 0;
      break;
    }
  }
  return basis;
}

Eigen::Vector3d extentShift(const SweptBlock& block, int node, int station) {
  if (block.extent.empty()) return {0, 0, 0};
  return {0, (block.extent[station] - 1) * (block.section.nodes[node][0] - block.lowest), 0};
}

Eigen::Vector3d nodePosition(const SweptBlock& block, int node, int station) {
  const auto& p = block.section.nodes[node];
  const double at = block.positions[station];
  const Eigen::Matrix3d basis = localBasis(block, at);
  if (block.kind == SweepKind::aroundAxis) return block.origin + basis * Eigen::Vector3d(0, p[0], p[1]);
  const Eigen::Vector3d even = block.origin + basis * Eigen::Vector3d(at, p[0], p[1]);
  return block.extent.empty() ? even : even + basis * extentShift(block, node, station);
}

Corners elementCorners(const SweptBlock& block, int quad, double length) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const auto& p = block.section.nodes[block.section.quads[quad][i]];
    for (int side = 0; side < 2; ++side) {
      const double at = (side ? 0.5 : -0.5) * length;
      if (block.kind == SweepKind::aroundAxis)
        corners[4 * side + i] = {p[0] * elementary::sin(at), p[0] * elementary::cos(at), p[1]};
      else
        corners[4 * side + i] = {at, p[0], p[1]};
    }
  }
  return corners;
}

Matrix24 localToMiddle(const SweptBlock& block, double length) {
  Matrix24 rotation = Matrix24::Identity();
  if (block.kind != SweepKind::aroundAxis) return rotation;
  for (int side = 0; side < 2; ++side) {
    const double at = (side ? 0.5 : -0.5) * length, c = elementary::cos(at), s = elementary::sin(at);
    Eigen::Matrix3d turn;  // columns: e_alpha, e_r, e_y at the station in axes (tangential, radial, y) of the middle
    turn << c, s, 0, -s, c, 0, 0, 0, 1;
    for (int i = 0; i < 4; ++i) rotation.block<3, 3>(12 * side + 3 * i, 12 * side + 3 * i) = turn;
  }
  return rotation;
}

Matrix24 elementStiffness(const SweptBlock& block, int quad, double length) {
  Matrix24 k = hexahedronStiffness(elementCorners(block, quad, length), block.material);
  if (block.kind != SweepKind::aroundAxis) return k;
  const Matrix24 rotation = localToMiddle(block, length);
  return rotation.transpose() * k * rotation;
}

namespace {

// What elements of another extent weigh more or less than those of the whole section, at their own nodes.
void addExtentMass(const SweptBlock& block, std::vector<double>& mass) {
  for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q)
    for (int s = 0; s < block.intervals; ++s) {
      const auto& quad = block.section.quads[q];
      const auto even = elementCorners(block, q, block.stations.runs[block.runOf(s)].length);
      auto own = even;
      for (int i = 0; i < 8; ++i) own[i] += extentShift(block, quad[i % 4], s + i / 4);
      const auto before = hexahedronMass(even, block.material.density);
      const auto after = hexahedronMass(own, block.material.density);
      for (int i = 0; i < 8; ++i) mass[quad[i % 4] * block.stride + s + i / 4] += after[i] - before[i];
    }
}

}  // namespace

std::vector<double> lumpedMass(const SweptBlock& block) {
  std::vector<double> mass(static_cast<std::size_t>(block.nodes) * block.stride, 0.0);
  for (std::size_t r = 0; r < block.runIntervals.size(); ++r) {
    std::vector<double> perNode(block.nodes, 0.0);
    for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q) {
      const auto corners = elementCorners(block, q, block.stations.runs[r].length);
      const auto share = hexahedronMass(corners, block.material.density);
      for (int i = 0; i < 4; ++i) perNode[block.section.quads[q][i]] += share[i];
    }
    for (int n = 0; n < block.nodes; ++n)
      for (int s = block.runIntervals[r][0]; s < block.runIntervals[r][1]; ++s) {
        const int right = block.closed && s + 1 == block.intervals ? 0 : s + 1;
        mass[n * block.stride + s] += perNode[n];
        mass[n * block.stride + right] += perNode[n];
      }
  }
  if (!block.extent.empty()) addExtentMass(block, mass);
  return mass;
}

std::vector<double> stiffnessDiagonal(const SweptBlock& block) {
  std::vector<double> diagonal(block.size(), 0.0);
  for (std::size_t r = 0; r < block.runIntervals.size(); ++r)
    for (int n = 0; n < block.nodes; ++n) {
      const double* pair = block.coefficients[r].data() + 18 * pairIndex(block, n, n);
      for (int c = 0; c < 3; ++c) {
        const double value = pair[4 * c] + pair[9 + 4 * c];
        const StateLine<double> line{diagonal.data() + block.index(n, c, 0) - block.offset, block.chunkSize()};
        for (int s = block.runIntervals[r][0]; s < block.runIntervals[r][1]; ++s) {
          line[s] += value;
          line[block.closed && s + 1 == block.intervals ? 0 : s + 1] += value;
        }
      }
    }
  return diagonal;
}

}  // namespace squat::elasticity
