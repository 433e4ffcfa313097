#include "statics/SectionShapes.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/DenseAlgebra.h"
#include "core/ElementaryFunctions.h"
#include "core/Errors.h"

namespace squat::statics {

namespace {

// Stiffness of the section against strain in its own plane, without what holds neighbouring sections together: the
// part of an interval's matrix that acts on equal b and c of both stations (S in elasticity/SweptBlock.h). Of the
// longest run; the length of the interval is a factor.
Eigen::SparseMatrix<double> planeStiffness(const elasticity::SweptBlock& block) {
  const auto& runs = block.stations.runs;
  const auto longest =
      std::max_element(runs.begin(), runs.end(), [](const auto& p, const auto& q) { return p.length < q.length; });
  const auto& coefficients = block.coefficients[static_cast<std::size_t>(longest - runs.begin())];
  std::vector<Eigen::Triplet<double>> entries;
  for (int node = 0; node < block.nodes; ++node)
    for (int pair = block.rowStart[node]; pair < block.rowStart[node + 1]; ++pair)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          entries.emplace_back(2 * node + i, 2 * block.columns[pair] + j,
                               coefficients[18 * static_cast<std::size_t>(pair) + 3 * (i + 1) + j + 1]);
  Eigen::SparseMatrix<double> stiffness(2 * block.nodes, 2 * block.nodes);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

// Of each displacement: its node's share of the area [m2].
Eigen::VectorXd areaShares(const geometry::SectionMesh& section) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(section.nodes.size()));
  for (const auto& quad : section.quads) {
    const auto &p = section.nodes[quad[0]], &q = section.nodes[quad[1]], &r = section.nodes[quad[2]],
               &s = section.nodes[quad[3]];
    const double area = 0.5 * std::abs((r[0] - p[0]) * (s[1] - q[1]) - (s[0] - q[0]) * (r[1] - p[1]));
    for (const int node : quad) shares.segment(2 * node, 2).array() += area / 4;
  }
  return shares;
}

SectionShape asShape(const Eigen::VectorXd& displacement) {
  SectionShape shape(static_cast<std::size_t>(displacement.size() / 2));
  const double largest = displacement.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < shape.size(); ++i)
    shape[i] = {displacement[2 * static_cast<Eigen::Index>(i)] / largest,
                displacement[2 * static_cast<Eigen::Index>(i) + 1] / largest};
  return shape;
}

}  // namespace

// Subspace iteration with Rayleigh and Ritz on K phi = lambda M phi. A few rounds are enough: any smooth fields near
// the softest serve a coarse space.
std::vector<SectionShape> softestShapes(const elasticity::SweptBlock& block, int count) {
  constexpr int rigid = 3, spare = 5, rounds = 12;
  const auto stiffness = planeStiffness(block);
  const Eigen::VectorXd root = areaShares(block.section).cwiseSqrt();
  const Eigen::Index size = root.size(), width = std::min<Eigen::Index>(size, rigid + count + spare);
  // Small against the softest shape, large against round-off: rigid motions get this stiffness.
  Eigen::SparseMatrix<double> shifted = stiffness;
  const double shift = 1e-7 * (stiffness.diagonal().array() / root.array().square()).maxCoeff();
  shifted.diagonal() += shift * root.cwiseAbs2();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(shifted);
  if (factor.info() != Eigen::Success)
    throw RunError("the section of " + block.name + " has no natural shapes: one of its nodes belongs to no element", 0,
                   0, block.name);
  Eigen::MatrixXd basis(size, width);  // M^(1/2) phi
  for (Eigen::Index j = 0; j < width; ++j)
    for (Eigen::Index i = 0; i < size; ++i) basis(i, j) = elementary::sin(1.0 + static_cast<double>(i * (2 * j + 3)));
  for (int round = 0; round < rounds; ++round) {
    basis = factor.solve(root.asDiagonal() * basis).eval();
    const Eigen::MatrixXd q = algebra::orthonormalColumns(root.asDiagonal() * basis);
    const Eigen::MatrixXd shapes = root.cwiseInverse().asDiagonal() * q;
    basis = q * algebra::symmetricEigenPairs(shapes.transpose() * (stiffness * shapes)).vectors;
  }
  std::vector<SectionShape> softest;
  for (Eigen::Index k = rigid; k < std::min<Eigen::Index>(width, rigid + count); ++k)
    softest.push_back(asShape(root.cwiseInverse().cwiseProduct(basis.col(k))));
  return softest;
}

}  // namespace squat::statics
