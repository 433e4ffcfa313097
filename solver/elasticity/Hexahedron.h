// solver/elasticity/Hexahedron.h - the 8-node solid: trilinear with incompatible modes, condensed ahead of the run.
#pragma once

#include <Eigen/Core>
#include <array>

#include "scenario/Material.h"

namespace squat::elasticity {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix24 = Eigen::Matrix<double, 24, 24>;
using Strain24 = Eigen::Matrix<double, 6, 24>;
using Corners = std::array<Eigen::Vector3d, 8>;

// Hooke's matrix for the strains (xx, yy, zz, 2xy, 2yz, 2zx) [Pa].
Matrix6 elasticityMatrix(const scenario::Material& material);

// Corners 0-3 are a quad, counter-clockwise seen against the sweep, 4-7 the same quad one station on. Unknowns: 3 a
// corner. Incompatible modes after Wilson with Taylor's correction (R. L. Taylor, P. J. Beresford, E. L. Wilson 1976),
// the same as the nine-parameter enhanced strain of Simo and Rifai (1990): passes the patch test for any shape, no
// shear locking, no hourglass modes. Throws std::invalid_argument when the Jacobian is not positive at an integration
// point.
Matrix24 hexahedronStiffness(const Corners& corners, const scenario::Material& material);

// The same element point by point, for laws that act on the strain at the 2x2x2 integration points. With the modes
// condensed, the strain at point p is
//   strain[p] u + inner[p] sum_q amplitude[q] sigma_q
// for corner displacements u and initial stresses sigma_q = D eps_q; the sum is what eps_q adds to the amplitudes of
// the incompatible modes, alpha = -Kaa^-1 (Kau u - f_a). eps_q then pushes the corners with sum_q weight[q] strain[q]^T
// sigma_q, and hexahedronStiffness() is sum_q weight[q] strain[q]^T D strain[q] with the strains of u alone.
using Inner9 = Eigen::Matrix<double, 6, 9>;
struct HexahedronPoints {
  std::array<Strain24, 8> strain;
  std::array<Inner9, 8> inner;
  std::array<Eigen::Matrix<double, 9, 6>, 8> amplitude;
  std::array<double, 8> weight;  // [m3]
};
HexahedronPoints hexahedronPoints(const Corners& corners, const scenario::Material& material);

// Mass of each corner, row sums of the consistent matrix [kg].
std::array<double, 8> hexahedronMass(const Corners& corners, double density);

// Strain at the centre (incompatible modes vanish there) as a function of the 24 displacements.
Strain24 centreStrain(const Corners& corners);

// Smallest Jacobian determinant over the corners divided by that of the centre; 1 is a brick, below 0 inverted.
double jacobianRatio(const Corners& corners);

// Trilinear shape functions at (xi, eta, zeta) in corner order, and the point's reference coordinates by Newton's
// method.
std::array<double, 8> hexahedronShape(double xi, double eta, double zeta);
Eigen::Vector3d referenceCoordinates(const Corners& corners, const Eigen::Vector3d& point);

// Shape gradients at a reference point [1/m] (8 columns) and the Jacobian determinant.
Eigen::Matrix<double, 3, 8> shapeGradients(const Corners& corners, double xi, double eta, double zeta,
                                           double& determinant);

}  // namespace squat::elasticity
