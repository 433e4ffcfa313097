#include "elasticity/Hexahedron.h"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

namespace squat::elasticity {

namespace {

// Reference coordinates of the corners: quad in (xi, eta), sweep along zeta.
constexpr double cornerXi[8] = {-1, 1, 1, -1, -1, 1, 1, -1};
constexpr double cornerEta[8] = {-1, -1, 1, 1, -1, -1, 1, 1};
constexpr double cornerZeta[8] = {-1, -1, -1, -1, 1, 1, 1, 1};

Eigen::Matrix<double, 3, 8> referenceGradients(double xi, double eta, double zeta) {
  Eigen::Matrix<double, 3, 8> d;
  for (int i = 0; i < 8; ++i) {
    const double x = 1 + cornerXi[i] * xi, e = 1 + cornerEta[i] * eta, z = 1 + cornerZeta[i] * zeta;
    d.col(i) << cornerXi[i] * e * z / 8, cornerEta[i] * x * z / 8, cornerZeta[i] * x * e / 8;
  }
  return d;
}

// Rows: derivative of the position by (xi, eta, zeta).
Eigen::Matrix3d jacobian(const Corners& corners, const Eigen::Matrix<double, 3, 8>& reference) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 8; ++i) j += reference.col(i) * corners[i].transpose();
  return j;
}

// Strain operator of displacement modes with the given gradients (columns).
template <int Modes>
Eigen::Matrix<double, 6, 3 * Modes> strainOperator(const Eigen::Matrix<double, 3, Modes>& g) {
  Eigen::Matrix<double, 6, 3 * Modes> b = Eigen::Matrix<double, 6, 3 * Modes>::Zero();
  for (int i = 0; i < Modes; ++i) {
    const double x = g(0, i), y = g(1, i), z = g(2, i);
    b.col(3 * i) << x, 0, 0, y, 0, z;
    b.col(3 * i + 1) << 0, y, 0, x, z, 0;
    b.col(3 * i + 2) << 0, 0, z, 0, y, x;
  }
  return b;
}

// Strain operators of corners and incompatible modes at the integration points.
struct BarePoints {
  Strain24 strain[8];
  Inner9 inner[8];
  double weight[8];
};

BarePoints barePoints(const Corners& corners) {
  const Eigen::Matrix3d centre = jacobian(corners, referenceGradients(0, 0, 0));
  const Eigen::Matrix3d centreInverse = centre.inverse();
  const double centreDeterminant = centre.determinant(), gauss = 1 / std::sqrt(3.0);
  BarePoints points;
  for (int p = 0; p < 8; ++p) {
    const Eigen::Vector3d at(gauss * cornerXi[p], gauss * cornerEta[p], gauss * cornerZeta[p]);
    double& determinant = points.weight[p];
    const auto gradients = shapeGradients(corners, at[0], at[1], at[2], determinant);
    if (!(determinant > 0)) throw std::invalid_argument("hexahedron with a Jacobian that is not positive");
    points.strain[p] = strainOperator<8>(gradients);
    // Modes 1 - xi^2, 1 - eta^2, 1 - zeta^2 with the Jacobian of the centre: their strains integrate to zero.
    const Eigen::Matrix3d bubble = (centreDeterminant / determinant) * centreInverse * (-2 * at).asDiagonal();
    points.inner[p] = strainOperator<3>(bubble);
  }
  return points;
}

struct InnerMatrices {
  Eigen::Matrix<double, 9, 9> inner = Eigen::Matrix<double, 9, 9>::Zero();
  Eigen::Matrix<double, 24, 9> coupling = Eigen::Matrix<double, 24, 9>::Zero();
};

InnerMatrices innerMatrices(const BarePoints& points, const Matrix6& d) {
  InnerMatrices sums;
  for (int p = 0; p < 8; ++p) {
    const Eigen::Matrix<double, 6, 9> stress = d * points.inner[p] * points.weight[p];
    sums.coupling += points.strain[p].transpose() * stress;
    sums.inner += points.inner[p].transpose() * stress;
  }
  return sums;
}

}  // namespace

Matrix6 elasticityMatrix(const scenario::Material& material) {
  const double e = material.young, nu = material.poisson;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  Matrix6 d = Matrix6::Zero();
  d.topLeftCorner<3, 3>().setConstant(lambda);
  for (int i = 0; i < 3; ++i) d(i, i) += 2 * mu, d(i + 3, i + 3) = mu;
  return d;
}

Eigen::Matrix<double, 3, 8> shapeGradients(const Corners& corners, double xi, double eta, double zeta,
                                           double& determinant) {
  const auto reference = referenceGradients(xi, eta, zeta);
  const Eigen::Matrix3d j = jacobian(corners, reference);
  determinant = j.determinant();
  return j.inverse() * reference;
}

Matrix24 hexahedronStiffness(const Corners& corners, const scenario::Material& material) {
  const Matrix6 d = elasticityMatrix(material);
  const BarePoints bare = barePoints(corners);
  Matrix24 k = Matrix24::Zero();
  for (int p = 0; p < 8; ++p) k += bare.strain[p].transpose() * d * bare.strain[p] * bare.weight[p];
  const auto [inner, coupling] = innerMatrices(bare, d);
  k -= coupling * inner.ldlt().solve(coupling.transpose());
  return 0.5 * (k + k.transpose());
}

HexahedronPoints hexahedronPoints(const Corners& corners, const scenario::Material& material) {
  const Matrix6 d = elasticityMatrix(material);
  const BarePoints bare = barePoints(corners);
  const auto [inner, coupling] = innerMatrices(bare, d);
  const auto factor = inner.ldlt();
  const Eigen::Matrix<double, 9, 24> condensed = factor.solve(coupling.transpose());
  HexahedronPoints points;
  for (int p = 0; p < 8; ++p) {
    points.strain[p] = bare.strain[p] - bare.inner[p] * condensed;
    points.inner[p] = bare.inner[p];
    points.amplitude[p] = factor.solve(bare.inner[p].transpose()) * bare.weight[p];
    points.weight[p] = bare.weight[p];
  }
  return points;
}

std::array<double, 8> hexahedronMass(const Corners& corners, double density) {
  std::array<double, 8> mass{};
  const double gauss = 1 / std::sqrt(3.0);
  for (int p = 0; p < 8; ++p) {
    const double xi = gauss * cornerXi[p], eta = gauss * cornerEta[p], zeta = gauss * cornerZeta[p];
    const double determinant = jacobian(corners, referenceGradients(xi, eta, zeta)).determinant();
    const auto shape = hexahedronShape(xi, eta, zeta);
    for (int i = 0; i < 8; ++i) mass[i] += density * shape[i] * determinant;
  }
  return mass;
}

Strain24 centreStrain(const Corners& corners) {
  double determinant = 0;
  return strainOperator<8>(shapeGradients(corners, 0, 0, 0, determinant));
}

double jacobianRatio(const Corners& corners) {
  const double centre = jacobian(corners, referenceGradients(0, 0, 0)).determinant();
  double smallest = 1;
  for (int i = 0; i < 8; ++i)
    smallest = std::min(
        smallest,
        jacobian(corners, referenceGradients(cornerXi[i], cornerEta[i], cornerZeta[i])).determinant() / centre);
  return smallest;
}

std::array<double, 8> hexahedronShape(double xi, double eta, double zeta) {
  std::array<double, 8> n;
  for (int i = 0; i < 8; ++i) n[i] = (1 + cornerXi[i] * xi) * (1 + cornerEta[i] * eta) * (1 + cornerZeta[i] * zeta) / 8;
  return n;
}

Eigen::Vector3d referenceCoordinates(const Corners& corners, const Eigen::Vector3d& point) {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (int iteration = 0; iteration < 50; ++iteration) {
    const auto shape = hexahedronShape(at[0], at[1], at[2]);
    Eigen::Vector3d rest = point;
    for (int i = 0; i < 8; ++i) rest -= shape[i] * corners[i];
    const Eigen::Vector3d change =
        jacobian(corners, referenceGradients(at[0], at[1], at[2])).transpose().inverse() * rest;
    at += change;
    if (change.norm() < 1e-13) break;
  }
  return at;
}

}  // namespace squat::elasticity
