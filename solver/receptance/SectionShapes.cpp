#include "receptance/SectionShapes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/DenseAlgebra.h"
#include "elasticity/StandingWave.h"

namespace squat::receptance {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int modesOfAWave = 12;
constexpr double modeWaves[] = {0.5, 3, 7, 12, 25}, forceWaves[] = {5, 20, 60};  // [rad/m]

// Unknowns of the section on which springs or load act; dashpots at the rail's ends take whole sections as they are.
std::vector<Index> loadedUnknowns(const model::Model& model) {
  const auto& rail = model.blocks[model.rail];
  std::set<Index> found;
  for (const auto& set : model.forceElements)
    for (std::size_t i = 0; i < set.size(); ++i)
      for (const auto& [index, weight] : set.terms(i))
        if (set.stiffness[i] > 0 && index >= rail.offset && index < rail.offset + rail.size())
          found.insert(3 * rail.unknownAt(index).node + rail.unknownAt(index).component);
  for (const int node : model.surfaces.railLine)
    if (std::abs(rail.section.nodes[node][0]) < 0.012) found.insert(3 * node + 2);
  return {found.begin(), found.end()};
}

// Orthonormal columns that span `first` and, but for what is small, the others.
MatrixXd spanOf(const MatrixXd& first, MatrixXd columns, double tolerance) {
  const MatrixXd kernel = algebra::orthonormalColumns(first);
  for (int twice = 0; twice < 2; ++twice) columns -= kernel * (kernel.transpose() * columns).eval();
  const auto eigen = algebra::symmetricEigenPairs(columns.transpose() * columns);
  const double largest = eigen.values.tail(1)[0];
  Index kept = 0;
  while (kept < columns.cols() && eigen.values[columns.cols() - 1 - kept] > tolerance * tolerance * largest) ++kept;
  MatrixXd basis = columns * eigen.vectors.rightCols(kept);
  for (Index k = 0; k < kept; ++k) basis.col(k) /= std::sqrt(eigen.values[columns.cols() - kept + k]);
  MatrixXd all(columns.rows(), kernel.cols() + kept);
  all << kernel, basis;
  return all;
}

VectorXd massPerMetre(const elasticity::SweptBlock& block) {
  const auto lumped = elasticity::lumpedMass(block);
  const double length = block.stations.runs[0].length;
  VectorXd mass(3 * block.nodes);
  for (int n = 0; n < block.nodes; ++n) mass.segment<3>(3 * n).setConstant(lumped[n * block.stride + 1] / length);
  return mass;
}

// For every node the one on the other side of the axis of symmetry; empty where the section has none.
std::vector<int> mirrorOf(const geometry::SectionMesh& section) {
  std::vector<int> mirror;
  for (const auto& p : section.nodes) {
    const auto at = std::find_if(section.nodes.begin(), section.nodes.end(), [&](const geometry::Point2& q) {
      return std::abs(p[0] + q[0]) < 1e-9 && std::abs(p[1] - q[1]) < 1e-9;
    });
    if (at == section.nodes.end()) return {};
    mirror.push_back(static_cast<int>(at - section.nodes.begin()));
  }
  return mirror;
}

// Columns and their mirror images, added (sign +1: bending upright) or subtracted (-1: sideways, torsion).
MatrixXd mirrored(const MatrixXd& columns, const std::vector<int>& mirror, double sign) {
  MatrixXd result = 0.5 * columns;
  for (Index n = 0; n < static_cast<Index>(mirror.size()); ++n)
    for (Index c = 0; c < 3; ++c)
      result.row(3 * n + c) +=
          0.5 * sign * (c == 1 ? -1 : 1) * columns.row(3 * mirror[static_cast<std::size_t>(n)] + c);
  return result;
}

// Those that are not next to zero, at length one.
MatrixXd normalised(const MatrixXd& columns) {
  std::vector<Index> kept;
  for (Index c = 0; c < columns.cols(); ++c)
    if (columns.col(c).norm() > 1e-5) kept.push_back(c);
  MatrixXd result(columns.rows(), static_cast<Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) result.col(static_cast<Index>(k)) = columns.col(kept[k]).normalized();
  return result;
}

}  // namespace

SectionShapes allShapes(const elasticity::SweptBlock& block) {
  SectionShapes all;
  all.massPerMetre = massPerMetre(block);
  all.turn = VectorXd::Ones(3 * block.nodes);
  all.turn.head(block.nodes).setConstant(-1);
  all.families = {3 * block.nodes};
  all.shapes = MatrixXd::Zero(3 * block.nodes, 3 * block.nodes);
  for (int n = 0; n < block.nodes; ++n) {
    const double scale = 1 / std::sqrt(all.massPerMetre[3 * n]);
    all.shapes(3 * n, n) = all.shapes(3 * n + 1, block.nodes + 2 * n) = scale;
    all.shapes(3 * n + 2, block.nodes + 2 * n + 1) = scale;
  }
  return all;
}

SectionShapes railShapes(const model::Model& model, double tolerance) {
  const auto& rail = model.blocks[model.rail];
  // The shortest stations: the section's own numbers hardly depend on it.
  int run = 0;
  for (int r = 0; r < static_cast<int>(rail.stations.runs.size()); ++r)
    if (rail.stations.runs[r].length < rail.stations.runs[run].length) run = r;
  const double length = rail.stations.runs[run].length;
  const auto interval = elasticity::intervalMatrices(rail, run);
  SectionShapes result;
  result.massPerMetre = massPerMetre(rail);
  const VectorXd root = result.massPerMetre.cwiseSqrt(), inverse = root.cwiseInverse();
  const Index size = root.size();

  std::vector<VectorXd> found;  // times the root of mass
  for (const double wave : modeWaves) {
    const MatrixXd k = elasticity::standingWaveStiffness(interval, 0.5 * wave * length) / length;
    const auto eigen = algebra::symmetricEigenPairs(inverse.asDiagonal() * k * inverse.asDiagonal());
    for (int m = 0; m < modesOfAWave; ++m) found.push_back(eigen.vectors.col(m));
  }
  const auto loaded = loadedUnknowns(model);
  for (const double wave : forceWaves) {
    const MatrixXd k = elasticity::standingWaveStiffness(interval, 0.5 * wave * length) / length;
    const algebra::SymmetricFactor factor(k);
    for (const Index at : loaded)
      found.push_back(root.cwiseProduct(factor.solve(VectorXd::Unit(size, at))).normalized());
  }
  // Along and across by themselves: their phases differ along the rail.
  MatrixXd along = MatrixXd::Zero(size, static_cast<Index>(found.size())), across = along;
  for (std::size_t k = 0; k < found.size(); ++k)
    for (Index i = 0; i < size; ++i) (i % 3 ? across : along)(i, static_cast<Index>(k)) = found[k][i];
  // What a beam does stands first: stretch and the plane section's two turns; two shifts and the turn about the axis.
  MatrixXd beamAlong = MatrixXd::Zero(size, 3), beamAcross = MatrixXd::Zero(size, 3);
  for (Index n = 0; n < rail.nodes; ++n) {
    const auto& p = rail.section.nodes[static_cast<std::size_t>(n)];
    beamAlong.row(3 * n) << 1, p[0], p[1];
    beamAcross.row(3 * n + 1) << 1, 0, -p[1];
    beamAcross.row(3 * n + 2) << 0, 1, p[0];
  }
  beamAlong = (root.asDiagonal() * beamAlong).eval(), beamAcross = (root.asDiagonal() * beamAcross).eval();
  const auto mirror = mirrorOf(rail.section);
  std::vector<MatrixXd> parts;
  for (const double sign : mirror.empty() ? std::vector<double>{0} : std::vector<double>{1, -1}) {
    int family = 0;
    for (const auto& [beam, columns, turn] :
         {std::tuple{&beamAlong, &along, -1.0}, std::tuple{&beamAcross, &across, 1.0}}) {
      const auto own = [&](const MatrixXd& all) { return normalised(sign == 0 ? all : mirrored(all, mirror, sign)); };
      parts.push_back(inverse.asDiagonal() * spanOf(own(*beam), own(*columns), tolerance));
      const Index before = result.turn.size(), count = parts.back().cols();
      result.turn.conservativeResize(before + count);
      result.turn.tail(count).setConstant(turn);
      family += static_cast<int>(count);
    }
    result.families.push_back(family);
  }
  result.shapes.resize(size, result.turn.size());
  Index at = 0;
  for (const auto& part : parts) result.shapes.middleCols(at, part.cols()) = part, at += part.cols();
  return result;
}

}  // namespace squat::receptance
