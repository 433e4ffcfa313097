// tests/verification/PlainPlasticity.h - elastic-plastic hexahedra the ordinary way: every element for itself, strains
// and stresses at all of its integration points in every step, the incompatible modes by Newton's method. Shares with
// the program the shape gradients and nothing else.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "elasticity/Hexahedron.h"

namespace squat::elasticity {

struct PlainLaw {
  double yieldStress = 0, hardening = 0;  // [Pa]
  bool kinematic = false;
};

struct PlainElement {
  Corners corners;
  std::array<std::size_t, 8> node;  // places in the displacement, three components each
};

class PlainBody {
 public:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  PlainBody(std::vector<PlainElement> elements, const scenario::Material& material, const PlainLaw& law);

  // Forces of the stresses at these displacements (3 a node); plastic flow goes on from the last call.
  Eigen::VectorXd innerForce(const Eigen::VectorXd& u);

  // Mean plastic strain of an element (xx, yy, zz, 2xy, 2yz, 2zx) and its mean equivalent plastic strain.
  Vector6 plasticStrain(std::size_t element) const;
  double equivalent(std::size_t element) const;

 private:
  struct Point {
    Eigen::Matrix<double, 6, 24> strain;
    Eigen::Matrix<double, 6, 9> inner;
    double weight = 0;
    Vector6 plastic = Vector6::Zero();
    double equivalent = 0;
  };
  struct Returned {
    Vector6 stress, plastic;
    double equivalent;
    Matrix6 tangent;
  };
  Returned returned(const Point& point, const Vector6& strain) const;

  std::vector<PlainElement> elements_;
  std::vector<std::array<Point, 8>> points_;
  std::vector<Eigen::Matrix<double, 9, 1>> amplitude_;
  Matrix6 hooke_;
  double shear_;
  PlainLaw law_;
};

}  // namespace squat::elasticity
