// solver/contact/RollingContact.h - penalty pressure and Coulomb friction between wheel and rail while rolling.
//
// Pressure p = k * penetration at each closed point; traction grows with the slip, t' = kt (v_wheel - v_rail), and is
// returned to the friction cone |t| <= mu p. The tractions are carried by the rail's points: they enter and leave the
// patch with the material.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/TouchPoint.h"
#include "contact/WearLaw.h"

namespace squat::contact {

struct ContactLaw {
  double normalPenalty = 0, tangentialPenalty = 0;  // [Pa/m]
  double friction = 0;
  WearLaw wear;
};

// How the wheel moves besides its nodal velocities.
struct WheelRolling {
  WheelPlacement placement;
  double speed = 0;            // [m/s] of the reference along x
  double angularVelocity = 0;  // [rad/s]
};

// Tractions on the rail, along e_alpha and y [Pa]; zero where open. Two per contact point of the surfaces.
struct FrictionHistory {
  std::vector<double> traction;
  std::vector<std::size_t> closed;  // points closed in the last step
  std::vector<double> worn;         // [m] depth taken off each point; empty: not asked for
};

struct PatchState {
  double vertical = 0;           // [N] of the wheel on the rail, downwards
  double longitudinal = 0;       // [N] of the wheel on the rail, along x
  double lateral = 0;            // [N]
  double rotationMoment = 0;     // [N m] on the wheel about y, arms those of its reference
  double length = 0, width = 0;  // [m] 2 sqrt(5 <x^2>), 2 sqrt(5 <y^2>) of the pressure
  double storedEnergy = 0;       // [J] in the penalties
  double frictionPower = 0;      // [W] dissipated
  double deepest = 0;            // [m] largest penetration
  int points = 0, slipping = 0;
};

// One closed point, for pictures.
struct PatchPoint {
  double x = 0, y = 0, pressure = 0, tractionX = 0, tractionY = 0, area = 0;
  bool slips = false;
};

// Shares that surface nodes have in the closed area, one entry for each closed point and node: weights of the
// interpolation times the point's area.
struct AreaShare {
  int node = 0, station = 0;
  double area = 0;  // [m2]
};
// Of the closed points of one evaluation, in their order.
struct ClosedArea {
  std::vector<AreaShare> rail, rim;
};

// Where forces on surface nodes are collected: triples of lines of a block.
struct ForceLines {
  double* lines = nullptr;
  const int* lineOfNode = nullptr;
};

// A contact point of the rail, by its face and its place in it.
struct RailPoint {
  int interval = 0, column = 0, point = 0;
};
// What rolls on what.
struct ContactPair {
  const Surfaces& surfaces;
  const elasticity::SweptBlock &rail, &rim;
  ContactLaw law;
};
// How both move during a step; displacements [m] and velocities [m/s] in state layout.
struct ContactMotion {
  WheelRolling wheel;
  const double* displaced = nullptr;
  const double* velocity = nullptr;
  double step = 0;  // [s]
};
struct ContactForces {
  ForceLines rail, rim;
};

// Points within reach whose gap is below `margin` [m], in ascending order: while no gap closes by more than that, no
// other can touch.
std::vector<RailPoint> pointsWithin(double margin, const ContactPair& pair, const WheelPlacement& wheel,
                                    const double* displaced);

struct ContactScope {
  const std::vector<RailPoint>* among = nullptr;  // points to evaluate, as from pointsWithin(); null: all within reach
  std::vector<PatchPoint>* points = nullptr;      // receive the closed points where they are given
  ClosedArea* closed = nullptr;
};

// Evaluates the patch, updates the friction history over the step and adds the forces.
PatchState rollContact(const ContactPair& pair, const ContactMotion& motion, FrictionHistory& history,
                       const ContactForces& forces, const ContactScope& scope = {});

}  // namespace squat::contact
