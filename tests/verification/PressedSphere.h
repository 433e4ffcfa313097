// tests/verification/PressedSphere.h - a steel sphere pressed, then shifted, on a steel block: contact of half spaces.
//
// Two bodies of one material share gap and approach evenly: the block sees half of the gap, r^2 / 4 R, and a penalty of
// 2 k; tangential tractions, equal and opposite on both, move the block by half of the shift. The block is a quarter of
// the half space out to five contact radii; its far faces are held at the displacements of a point load on a half space
// (J. Boussinesq, V. Cerruti; K. L. Johnson, Contact Mechanics, 3.2 and 3.6), so that what is missing of the half space
// is in the model.
#pragma once

#include <functional>
#include <vector>

#include "elasticity/SweptSamples.h"

namespace squat::elasticity {

struct PressedCase {
  double radius = 0.4;                        // [m] of the sphere
  double halfAxis = 0.006;                    // [m] of the contact after Hertz
  double size = 0.0013;                       // [m] of elements in the contact
  double penalty = 2.5, tangentialShare = 1;  // in units of E / size; of the normal one
  double friction = 0.3;

  double effectiveModulus() const { return steel.young / (2 * (1 - steel.poisson * steel.poisson)); }
  double shearModulus() const { return steel.young / 2 / (1 + steel.poisson); }
  // [N] that gives the half axis.
  double load() const { return 4 * effectiveModulus() * halfAxis * halfAxis * halfAxis / (3 * radius); }
};

class PressedSphere {
 public:
  explicit PressedSphere(const PressedCase& with);

  struct Pressed {
    double a = 0, b = 0, peak = 0;          // [m], [m], [Pa] by moments
    double approach = 0, penaltyShare = 0;  // [m] of the bodies, without the penalty's share p0 / 2k; that share
  };
  Pressed press();

  struct Shifted {
    double force = 0;         // [N] tangential, on the whole contact
    double stickRadius = 0;   // [m] of a circle with the area of the points that stick
    double penaltyShare = 0;  // [m] mean traction of the sticking points over the tangential penalty
  };
  // Shifts the sphere along x from the pressed state in equal steps; `farForce` [N] is the tangential force that the
  // far faces feel.
  Shifted shift(double distance, double farForce, int steps);

 private:
  struct Point {
    std::size_t corner[2][4];  // unknowns along x and z
    double weight[4];
    double area, x, y;
  };
  using Product = std::function<AlignedVector(const AlignedVector&)>;

  void fixUnknowns(bool shifted, const Field& far);
  void collectPoints();
  double value(const Point& p, int direction, const AlignedVector& u) const;
  double penetration(const Point& p) const;
  double forceAt(double sinking) const;
  AlignedVector residual();
  AlignedVector product(const AlignedVector& x) const;
  AlignedVector solve(const Product& matrix, AlignedVector r, double target) const;

  PressedCase with_;
  double penalty_;  // [Pa/m] that the block sees: twice the contact's
  double sinking_ = 0;
  std::vector<SweptBlock> blocks_;
  std::size_t size_ = 0;
  AlignedVector u_;
  std::vector<char> free_;
  std::vector<double> diagonal_;
  std::vector<Point> points_;
  std::vector<std::size_t> active_;  // closed points
  std::vector<double> pressure_;     // [Pa] at them
};

}  // namespace squat::elasticity
