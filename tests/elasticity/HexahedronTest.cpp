// The 8-node solid by itself: patch test, rigid motions, definiteness, mass.
// Patch test and its numbers: R. H. MacNeal, R. L. Harder, "A proposed standard set of problems to test finite element
// accuracy", Finite Elements in Analysis and Design 1 (1985), fig. 3 and table 2: seven distorted bricks in a cube.
#include "elasticity/Hexahedron.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

namespace squat::elasticity {
namespace {

constexpr scenario::Material patchMaterial{1e6, 0.25, 1.0};

const std::array<Eigen::Vector3d, 16>& patchNodes() {
  static const std::array<Eigen::Vector3d, 16> nodes{{{.249, .342, .192},
                                                      {.826, .288, .288},
                                                      {.850, .649, .263},
                                                      {.273, .750, .230},
                                                      {.320, .186, .643},
                                                      {.677, .305, .683},
                                                      {.788, .693, .644},
                                                      {.165, .745, .702},
                                                      {0, 0, 0},
                                                      {1, 0, 0},
                                                      {1, 1, 0},
                                                      {0, 1, 0},
                                                      {0, 0, 1},
                                                      {1, 0, 1},
                                                      {1, 1, 1},
                                                      {0, 1, 1}}};
  return nodes;
}

// The inner brick and one brick between each of its faces and the cube's.
std::vector<std::array<int, 8>> patchElements() {
  std::vector<std::array<int, 8>> elements{{0, 1, 2, 3, 4, 5, 6, 7}};
  const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const auto& f : faces) elements.push_back({f[0], f[1], f[2], f[3], f[0] + 8, f[1] + 8, f[2] + 8, f[3] + 8});
  return elements;
}

Corners cornersOf(const std::array<int, 8>& element) {
  Corners corners;
  for (int i = 0; i < 8; ++i) corners[i] = patchNodes()[element[i]];
  return corners;
}

Eigen::Vector3d patchField(const Eigen::Vector3d& p) {
  Eigen::Matrix3d strain;
  strain << 2, 1, 1, 1, 2, 1, 1, 1, 2;
  return 0.5e-3 * strain * p;
}

TEST(Hexahedron, PassesThePatchTestOfMacNealAndHarder) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(48, 48);
  for (const auto& element : patchElements()) {
    const Matrix24 own = hexahedronStiffness(cornersOf(element), patchMaterial);
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) k(3 * element[i / 3] + i % 3, 3 * element[j / 3] + j % 3) += own(i, j);
  }
  Eigen::VectorXd u(48);
  for (int n = 0; n < 16; ++n) u.segment<3>(3 * n) = patchField(patchNodes()[n]);
  // The cube's nodes are held, the inner eight are solved for.
  const Eigen::VectorXd inner = k.topLeftCorner<24, 24>().ldlt().solve(-k.topRightCorner<24, 24>() * u.tail<24>());
  // Round-off of a solution with a well conditioned 24 x 24 matrix.
  EXPECT_LT((inner - u.head<24>()).cwiseAbs().maxCoeff(), 1e-13 * 1e-3 * 100);
  u.head<24>() = inner;
  for (const auto& element : patchElements()) {
    Eigen::Matrix<double, 24, 1> own;
    for (int i = 0; i < 8; ++i) own.segment<3>(3 * i) = u.segment<3>(3 * element[i]);
    const Eigen::Matrix<double, 6, 1> stress =
        elasticityMatrix(patchMaterial) * (centreStrain(cornersOf(element)) * own);
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(stress[c], c < 3 ? 2000 : 400, 1e-8);
  }
}

// Distorted by a third of its edges.
Corners distortedBrick() {
  return {Eigen::Vector3d{0, 0, 0},   {1.1, 0.2, -0.1}, {1.3, 1.0, 0.2},  {-0.2, 0.9, 0.1},
          Eigen::Vector3d{0.3, 0, 1}, {1.0, -0.1, 0.8}, {0.9, 1.2, 1.25}, {0.1, 0.8, 0.9}};
}

TEST(Hexahedron, HasSixRigidMotionsAndNoOtherMotionWithoutForce) {
  const Matrix24 k = hexahedronStiffness(distortedBrick(), patchMaterial);
  EXPECT_EQ((k - k.transpose()).cwiseAbs().maxCoeff(), 0);
  const Eigen::SelfAdjointEigenSolver<Matrix24> modes(k);
  const double top = modes.eigenvalues()[23];
  for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(modes.eigenvalues()[i]), 1e-13 * top);
  // A brick without hourglass modes: the softest deformation is bending, not far below shear.
  EXPECT_GT(modes.eigenvalues()[6], 1e-3 * top);
}

TEST(Hexahedron, BendsLikeABeamWithoutLocking) {
  // One brick of 10 x 1 x 1 in pure bending, plane sections kept: moment E I / L per rotation to round-off, because the
  // incompatible modes carry the curvature and the anticlastic surface. nu = 0: E I exact; nu = 0.3: the same.
  for (const double nu : {0.0, 0.3}) {
    Corners corners;
    const double length = 10;
    for (int i = 0; i < 8; ++i)
      corners[i] = {i < 4 ? 0 : length, (i % 4 == 1 || i % 4 == 2) ? 0.5 : -0.5, i % 4 >= 2 ? 0.5 : -0.5};
    const Matrix24 k = hexahedronStiffness(corners, {1, nu, 1});
    // Ends turned by -+ half a unit about z; the lateral motion is left free (least energy).
    Eigen::Matrix<double, 24, 1> u = Eigen::Matrix<double, 24, 1>::Zero();
    std::vector<int> fixed, open;
    for (int i = 0; i < 8; ++i) {
      u[3 * i] = (i < 4 ? 0.5 : -0.5) * corners[i][1];
      fixed.push_back(3 * i);
      for (int c = 1; c < 3; ++c) (i == 0 || (i == 1 && c == 2) || (i == 4) ? fixed : open).push_back(3 * i + c);
    }
    Eigen::MatrixXd koo(open.size(), open.size());
    Eigen::VectorXd load(open.size());
    const Eigen::Matrix<double, 24, 1> f = k * u;
    for (std::size_t i = 0; i < open.size(); ++i) {
      load[i] = -f[open[i]];
      for (std::size_t j = 0; j < open.size(); ++j) koo(i, j) = k(open[i], open[j]);
    }
    const Eigen::VectorXd rest = koo.ldlt().solve(load);
    for (std::size_t i = 0; i < open.size(); ++i) u[open[i]] = rest[i];
    const double energy = 0.5 * u.dot(k * u), expected = 0.5 * (1.0 / 12) / length;  // E I / L, I = 1/12
    EXPECT_NEAR(energy, expected, 1e-10 * expected) << "nu " << nu;
  }
}

TEST(Hexahedron, MassIsDensityTimesVolume) {
  // Volume of the distorted brick by splitting it into six tetrahedra around its main diagonal would bend the faces;
  // a sheared brick keeps them plane: volume = product of the edges.
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const double x = (i % 4 == 1 || i % 4 == 2) ? 2 : 0, y = i % 4 >= 2 ? 3 : 0, z = i >= 4 ? 5 : 0;
    corners[i] = {x + 0.3 * y + 0.2 * z, y - 0.4 * z, z};
  }
  double sum = 0;
  for (const double m : hexahedronMass(corners, 7800)) {
    EXPECT_NEAR(m, 7800 * 30 / 8.0, 1e-6);
    sum += m;
  }
  EXPECT_NEAR(sum, 7800 * 30, 1e-6);
}

TEST(Hexahedron, FindsAPointFromItsPlace) {
  const Corners corners = distortedBrick();
  const double at[3] = {0.3, -0.7, 0.55};
  const auto shape = hexahedronShape(at[0], at[1], at[2]);
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (int i = 0; i < 8; ++i) p += shape[i] * corners[i];
  const Eigen::Vector3d found = referenceCoordinates(corners, p);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], at[c], 1e-12);
}

TEST(Hexahedron, RefusesAnInvertedElement) {
  Corners corners = distortedBrick();
  std::swap(corners[0], corners[6]);
  EXPECT_THROW(hexahedronStiffness(corners, patchMaterial), std::invalid_argument);
}

}  // namespace
}  // namespace squat::elasticity
