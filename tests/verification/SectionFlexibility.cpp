#include "verification/SectionFlexibility.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace squat::verification {

namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Quad {
  Eigen::Matrix<double, 8, 8> stiffness;
  Eigen::Vector4d area;  // shares of the nodes
};

Quad planeStrain(const Eigen::Matrix<double, 4, 2>& nodes, const scenario::Material& m) {
  const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, at = 1 / std::sqrt(3.0);
  const double scale = m.young / (1 + m.poisson) / (1 - 2 * m.poisson);
  Eigen::Matrix3d elastic;
  elastic << 1 - m.poisson, m.poisson, 0, m.poisson, 1 - m.poisson, 0, 0, 0, 0.5 - m.poisson;
  elastic *= scale;
  const auto localGradient = [&](double s, double t) {
    Eigen::Matrix<double, 2, 4> g;
    for (int i = 0; i < 4; ++i) {
      g(0, i) = 0.25 * corner[i][0] * (1 + t * corner[i][1]);
      g(1, i) = 0.25 * corner[i][1] * (1 + s * corner[i][0]);
    }
    return g;
  };
  const Matrix2d middle = localGradient(0, 0) * nodes;
  Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
  Quad quad;
  quad.area.setZero();
  for (const auto& c : corner) {
    const double s = at * c[0], t = at * c[1];
    const Eigen::Matrix<double, 2, 4> local = localGradient(s, t);
    const Matrix2d jacobian = local * nodes;
    const double weight = jacobian.determinant();
    Eigen::Matrix<double, 2, 6> gradient;
    gradient.leftCols<4>() = jacobian.inverse() * local;
    Matrix2d bubbles;
    bubbles << -2 * s, 0, 0, -2 * t;
    gradient.rightCols<2>() = middle.determinant() / weight * middle.inverse() * bubbles;
    Eigen::Matrix<double, 3, 12> strain = Eigen::Matrix<double, 3, 12>::Zero();
    for (int i = 0; i < 6; ++i) {
      strain(0, 2 * i) = strain(2, 2 * i + 1) = gradient(0, i);
      strain(1, 2 * i + 1) = strain(2, 2 * i) = gradient(1, i);
    }
    k += weight * strain.transpose() * elastic * strain;
    for (int i = 0; i < 4; ++i) quad.area[i] += weight * 0.25 * (1 + s * corner[i][0]) * (1 + t * corner[i][1]);
  }
  const Eigen::Matrix4d inner = k.bottomRightCorner<4, 4>();
  quad.stiffness = k.topLeftCorner<8, 8>() - k.topRightCorner<8, 4>() * inner.inverse() * k.bottomLeftCorner<4, 8>();
  return quad;
}

}  // namespace

double footFlexibility(const geometry::SectionMesh& section, const scenario::Material& material,
                       const std::vector<double>& springs, double stiffness) {
  const int size = 2 * static_cast<int>(section.nodes.size());
  std::vector<Eigen::Triplet<double>> entries;
  VectorXd area = VectorXd::Zero(size);
  for (const auto& corners : section.quads) {
    Eigen::Matrix<double, 4, 2> nodes;
    for (int i = 0; i < 4; ++i) nodes.row(i) << section.nodes[corners[i]][0], section.nodes[corners[i]][1];
    const auto quad = planeStrain(nodes, material);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j)
        entries.emplace_back(2 * corners[i / 2] + i % 2, 2 * corners[j / 2] + j % 2, quad.stiffness(i, j));
    for (int i = 0; i < 4; ++i) area[2 * corners[i] + 1] += quad.area[i];
  }
  double lowest = 0;
  for (const auto& p : section.nodes) lowest = std::min(lowest, p[1]);
  std::vector<std::pair<double, int>> base;
  for (int n = 0; n < size / 2; ++n)
    if (section.nodes[n][1] < lowest + 1e-9) base.emplace_back(section.nodes[n][0], n);
  std::sort(base.begin(), base.end());
  for (const double y : springs) {
    std::size_t j = 0;
    while (j + 2 < base.size() && base[j + 1].first < y) ++j;
    const double t = (y - base[j].first) / (base[j + 1].first - base[j].first);
    const std::pair<int, double> ends[2] = {{2 * base[j].second + 1, 1 - t}, {2 * base[j + 1].second + 1, t}};
    const double share = stiffness / static_cast<double>(springs.size());
    for (const auto& [a, wa] : ends)
      for (const auto& [b, wb] : ends) entries.emplace_back(a, b, share * wa * wb);
  }
  entries.emplace_back(2 * base.front().second, 2 * base.front().second, material.young);  // held sideways
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const VectorXd even = area / area.sum();
  const VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(even);
  return even.dot(u) - 1 / stiffness;
}

}  // namespace squat::verification
