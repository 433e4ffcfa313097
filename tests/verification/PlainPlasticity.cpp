#include "verification/PlainPlasticity.h"

#include <cmath>

namespace squat::elasticity {

namespace {

template <int Modes>
Eigen::Matrix<double, 6, 3 * Modes> strainOf(const Eigen::Matrix<double, 3, Modes>& gradient) {
  Eigen::Matrix<double, 6, 3 * Modes> b = Eigen::Matrix<double, 6, 3 * Modes>::Zero();
  for (int i = 0; i < Modes; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      b(axis, 3 * i + axis) = gradient(axis, i);
      const int next = (axis + 1) % 3;  // 2xy, 2yz, 2zx
      b(3 + axis, 3 * i + axis) = gradient(next, i);
      b(3 + axis, 3 * i + next) = gradient(axis, i);
    }
  return b;
}

}  // namespace

PlainBody::PlainBody(std::vector<PlainElement> elements, const scenario::Material& material, const PlainLaw& law)
    : elements_(std::move(elements)),
      hooke_(elasticityMatrix(material)),
      shear_(material.young / 2 / (1 + material.poisson)),
      law_(law) {
  amplitude_.assign(elements_.size(), Eigen::Matrix<double, 9, 1>::Zero());
  const double gauss = 1 / std::sqrt(3.0);
  for (const auto& element : elements_) {
    double centre = 0;
    const auto atCentre = shapeGradients(element.corners, 0, 0, 0, centre);
    // Inverse Jacobian of the centre from the gradients there: d(xi, eta, zeta)/dx = sum_i grad N_i (xi_i, ...)^T.
    constexpr double signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 3; ++k) inverse.col(k) += atCentre.col(i) * signs[i][k];
    std::array<Point, 8> own;
    for (int p = 0; p < 8; ++p) {
      const double at[3] = {gauss * signs[p][0], gauss * signs[p][1], gauss * signs[p][2]};
      own[p].strain = strainOf<8>(shapeGradients(element.corners, at[0], at[1], at[2], own[p].weight));
      Eigen::Matrix3d bubble;  // gradients of 1 - xi^2, 1 - eta^2, 1 - zeta^2 with Taylor's correction
      for (int k = 0; k < 3; ++k) bubble.col(k) = inverse.col(k) * (-2 * at[k]) * centre / own[p].weight;
      own[p].inner = strainOf<3>(bubble);
    }
    points_.push_back(own);
  }
}

PlainBody::Returned PlainBody::returned(const Point& point, const Vector6& strain) const {
  const double iso = law_.kinematic ? 0 : law_.hardening, kin = law_.kinematic ? law_.hardening : 0;
  Vector6 elastic = strain - point.plastic;
  Returned r{hooke_ * elastic, point.plastic, point.equivalent, hooke_};
  const double pressure = (r.stress[0] + r.stress[1] + r.stress[2]) / 3;
  Vector6 relative = r.stress;  // deviator less the back stress 2/3 H eps_p, as a tensor in six components
  for (int i = 0; i < 3; ++i) relative[i] -= pressure + 2.0 / 3 * kin * point.plastic[i];
  for (int i = 3; i < 6; ++i) relative[i] -= kin / 3 * point.plastic[i];
  const double norm = std::sqrt(relative.head<3>().squaredNorm() + 2 * relative.tail<3>().squaredNorm());
  const double excess = norm - std::sqrt(2.0 / 3) * (law_.yieldStress + iso * point.equivalent);
  if (excess <= 0) return r;
  const double stiffness = 2 * shear_ + 2.0 / 3 * law_.hardening, gamma = excess / stiffness;
  const Vector6 n = relative / norm;
  for (int i = 0; i < 3; ++i) r.plastic[i] += gamma * n[i];
  for (int i = 3; i < 6; ++i) r.plastic[i] += 2 * gamma * n[i];
  r.stress -= 2 * shear_ * gamma * n;
  r.equivalent += std::sqrt(2.0 / 3) * gamma;
  Matrix6 deviator = Matrix6::Zero();
  deviator.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(1.0 / 3);
  for (int i = 3; i < 6; ++i) deviator(i, i) = 0.5;
  const double turn = 2 * shear_ * gamma / norm;
  r.tangent -= 2 * shear_ * (turn * (deviator - n * n.transpose()) + 2 * shear_ / stiffness * n * n.transpose());
  return r;
}

Eigen::VectorXd PlainBody::innerForce(const Eigen::VectorXd& u) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(u.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    Eigen::Matrix<double, 24, 1> own, push = Eigen::Matrix<double, 24, 1>::Zero();
    for (int i = 0; i < 8; ++i)
      own.segment<3>(3 * i) = u.segment<3>(static_cast<Eigen::Index>(3 * elements_[e].node[i]));
    std::array<Returned, 8> now;
    for (int iteration = 0;; ++iteration) {
      Eigen::Matrix<double, 9, 1> rest = Eigen::Matrix<double, 9, 1>::Zero();
      Eigen::Matrix<double, 9, 9> tangent = Eigen::Matrix<double, 9, 9>::Zero();
      double size = 0;
      for (int p = 0; p < 8; ++p) {
        const auto& point = points_[e][p];
        now[p] = returned(point, point.strain * own + point.inner * amplitude_[e]);
        rest += point.inner.transpose() * now[p].stress * point.weight;
        size += (point.inner.transpose().cwiseAbs() * now[p].stress.cwiseAbs()).maxCoeff() * point.weight;
        tangent += point.inner.transpose() * now[p].tangent * point.inner * point.weight;
      }
      if (rest.norm() <= 1e-9 * size || iteration == 30) break;
      amplitude_[e] -= tangent.ldlt().solve(rest);
    }
    for (int p = 0; p < 8; ++p) {
      auto& point = points_[e][p];
      point.plastic = now[p].plastic, point.equivalent = now[p].equivalent;
      push += point.strain.transpose() * now[p].stress * point.weight;
    }
    for (int i = 0; i < 8; ++i)
      force.segment<3>(static_cast<Eigen::Index>(3 * elements_[e].node[i])) += push.segment<3>(3 * i);
  }
  return force;
}

PlainBody::Vector6 PlainBody::plasticStrain(std::size_t element) const {
  Vector6 mean = Vector6::Zero();
  for (const auto& point : points_[element]) mean += point.plastic / 8;
  return mean;
}

double PlainBody::equivalent(std::size_t element) const {
  double mean = 0;
  for (const auto& point : points_[element]) mean += point.equivalent / 8;
  return mean;
}

}  // namespace squat::elasticity
