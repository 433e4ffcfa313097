#include "verification/SectionTorsion.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <functional>

namespace squat::verification {

namespace {

// One Gauss point of a quad.
struct GaussPoint {
  Eigen::Vector4d shape;
  Eigen::Matrix<double, 2, 4> gradient;
  Eigen::Vector2d location;
  double weight = 0;
};

std::array<GaussPoint, 4> gaussPoints(const geometry::SectionMesh& mesh, int quad) {
  const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, at = 1 / std::sqrt(3.0);
  Eigen::Matrix<double, 4, 2> nodes;
  for (int i = 0; i < 4; ++i) nodes.row(i) << mesh.nodes[mesh.quads[quad][i]][0], mesh.nodes[mesh.quads[quad][i]][1];
  std::array<GaussPoint, 4> points;
  for (int k = 0; k < 4; ++k) {
    const double s = at * corner[k][0], t = at * corner[k][1];
    Eigen::Matrix<double, 2, 4> local;
    for (int i = 0; i < 4; ++i) {
      points[k].shape[i] = 0.25 * (1 + s * corner[i][0]) * (1 + t * corner[i][1]);
      local(0, i) = 0.25 * corner[i][0] * (1 + t * corner[i][1]);
      local(1, i) = 0.25 * corner[i][1] * (1 + s * corner[i][0]);
    }
    const Eigen::Matrix2d jacobian = local * nodes;
    points[k].gradient = jacobian.inverse() * local;
    points[k].location = nodes.transpose() * points[k].shape;
    points[k].weight = jacobian.determinant();
  }
  return points;
}

using Visit = std::function<void(const std::array<int, 4>&, const GaussPoint&)>;
void overSection(const geometry::SectionMesh& mesh, const Visit& visit) {
  for (int q = 0; q < static_cast<int>(mesh.quads.size()); ++q)
    for (const auto& point : gaussPoints(mesh, q)) visit(mesh.quads[q], point);
}

}  // namespace

TorsionConstants sectionTorsion(const geometry::SectionMesh& section) {
  TorsionConstants result;
  double first = 0;
  overSection(section, [&](const auto&, const GaussPoint& p) {
    result.area += p.weight, first += p.weight * p.location[1];
    result.lateralMoment += p.weight * p.location[0] * p.location[0];
  });
  result.centroid = first / result.area;
  const int n = static_cast<int>(section.nodes.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  overSection(section, [&](const auto& quad, const GaussPoint& p) {
    const double y = p.location[0], z = p.location[1] - result.centroid;
    result.polarMoment += p.weight * (y * y + z * z);
    for (int i = 0; i < 4; ++i) {
      load[quad[i]] += p.weight * (p.gradient(0, i) * z - p.gradient(1, i) * y);
      for (int j = 0; j < 4; ++j)
        entries.emplace_back(quad[i], quad[j], p.weight * p.gradient.col(i).dot(p.gradient.col(j)));
    }
  });
  entries.emplace_back(0, 0, 1.0);  // a constant does not warp: one node is held
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd w = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(load);

  double product = 0, mean = 0;
  overSection(section, [&](const auto& quad, const GaussPoint& p) {
    const double y = p.location[0], z = p.location[1] - result.centroid;
    const Eigen::Vector4d own(w[quad[0]], w[quad[1]], w[quad[2]], w[quad[3]]);
    const Eigen::Vector2d slope = p.gradient * own;
    result.torsion += p.weight * (std::pow(slope[0] - z, 2) + std::pow(slope[1] + y, 2));
    product += p.weight * p.shape.dot(own) * y, mean += p.weight * p.shape.dot(own) / result.area;
  });
  const double above = product / result.lateralMoment;
  result.shearCentre = result.centroid + above;
  overSection(section, [&](const auto& quad, const GaussPoint& p) {
    const Eigen::Vector4d own(w[quad[0]], w[quad[1]], w[quad[2]], w[quad[3]]);
    result.warping += p.weight * std::pow(p.shape.dot(own) - mean - above * p.location[0], 2);
  });
  return result;
}

std::vector<LateralMode> lateralTorsionModes(const TorsionConstants& c, const scenario::Material& material,
                                             double length, int count) {
  constexpr int elements = 60;
  const double h = length / elements, shear = material.young / 2 / (1 + material.poisson);
  // Cubic element: int N N, int N' N', int N'' N'' for values and slopes at both ends.
  Eigen::Matrix4d mass, first, second;
  mass << 156, 22 * h, 54, -13 * h, 22 * h, 4 * h * h, 13 * h, -3 * h * h, 54, 13 * h, 156, -22 * h, -13 * h,
      -3 * h * h, -22 * h, 4 * h * h;
  first << 36, 3 * h, -36, 3 * h, 3 * h, 4 * h * h, -3 * h, -h * h, -36, -3 * h, 36, -3 * h, 3 * h, -h * h, -3 * h,
      4 * h * h;
  second << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h, 6 * h, 2 * h * h,
      -6 * h, 4 * h * h;
  mass *= h / 420, first /= 30 * h, second /= h * h * h;
  const double e = c.shearCentre - c.centroid;
  const int n = 4 * (elements + 1);  // per node: v, v', t, t'
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n), m = k, turning = k;
  for (int i = 0; i < elements; ++i)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const int va = 4 * i + (a < 2 ? a : a + 2), vb = 4 * i + (b < 2 ? b : b + 2), ta = va + 2, tb = vb + 2;
        k(va, vb) += material.young * c.lateralMoment * second(a, b);
        k(ta, tb) += shear * c.torsion * first(a, b) + material.young * c.warping * second(a, b);
        m(va, vb) += material.density * c.area * mass(a, b);
        m(va, tb) += material.density * c.area * e * mass(a, b);
        m(ta, vb) += material.density * c.area * e * mass(a, b);
        m(ta, tb) += material.density * (c.area * e * e + c.polarMoment) * mass(a, b);
        turning(ta, tb) += material.density * c.polarMoment * mass(a, b);
      }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(k, m);
  std::vector<LateralMode> modes;
  for (int i = 0; i < n && static_cast<int>(modes.size()) < count; ++i) {
    const double value = solved.eigenvalues()[i];
    if (value < std::pow(2 * std::acos(-1.0), 2)) continue;  // rigid motions
    const Eigen::VectorXd x = solved.eigenvectors().col(i);
    modes.push_back({std::sqrt(value), x.dot(turning * x) / x.dot(m * x)});
  }
  return modes;
}

geometry::SectionMesh plate(std::pair<double, double> b, std::pair<double, double> c, int alongB, int alongC) {
  geometry::SectionMesh mesh;
  for (int j = 0; j <= alongC; ++j)
    for (int i = 0; i <= alongB; ++i)
      mesh.nodes.push_back({b.first + (b.second - b.first) * i / alongB, c.first + (c.second - c.first) * j / alongC});
  const int row = alongB + 1;
  for (int j = 0; j < alongC; ++j)
    for (int i = 0; i < alongB; ++i)
      mesh.quads.push_back({j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i});
  return mesh;
}

void join(geometry::SectionMesh& to, const geometry::SectionMesh& other) {
  std::vector<int> location;
  for (const auto& p : other.nodes) {
    int found = -1;
    for (int k = 0; k < static_cast<int>(to.nodes.size()) && found < 0; ++k)
      if (std::abs(to.nodes[k][0] - p[0]) < 1e-9 && std::abs(to.nodes[k][1] - p[1]) < 1e-9) found = k;
    if (found < 0) found = static_cast<int>(to.nodes.size()), to.nodes.push_back(p);
    location.push_back(found);
  }
  for (const auto& q : other.quads)
    to.quads.push_back({location[q[0]], location[q[1]], location[q[2]], location[q[3]]});
}

}  // namespace squat::verification
