// solver/scenario/Motion.h - how the wheel rolls, contact and damping.
#pragma once

namespace squat::scenario {

struct Motion {
  double speed = 0;                // [m/s]
  double angularVelocity = 0;      // [rad/s]; 0: free rolling, speed / radius
  double torque = 0;               // [N m] on the half wheelset
  double tractionCoefficient = 0;  // torque as a share of the wheel load times radius; 0: torque above counts
  double torqueRamp = 0;           // [s]
  double runUp = 0;                // [m] from start to the deepest point of the defect
  double beyond = 0;               // [m] rolled beyond it
  double lateralOffset = 0;        // [m] along the crown from its middle to where the wheel's running circle touches
  double gravity = 0;              // [m/s2]
};

struct Contact {
  double friction = 0;           // Coulomb
  double normalPenalty = 0;      // in units of E / (element size)
  double tangentialPenalty = 0;  // as a share of the normal one
};

struct Damping {
  double fraction = 0;  // of critical at the highest frequency of the mesh, stiffness-proportional
  double beta = 0;      // [s] explicit stiffness-proportional coefficient; 0: from the fraction
};

}  // namespace squat::scenario
