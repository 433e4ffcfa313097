// solver/statics/StaticContact.h - the closed points of a frictionless contact and the springs that they are; internal
// to the equilibrium.
#pragma once

#include <array>
#include <vector>

#include "forces/ForceElements.h"
#include "model/Model.h"
#include "model/WheelMotion.h"
#include "statics/Equilibrium.h"

namespace squat::statics {

struct ClosedContact {
  forces::ForceElements springs;                // tangent of the closed points
  std::vector<double> penetration;              // of each spring
  std::vector<std::array<double, 2>> location;  // x relative to the wheel, y
  double vertical = 0, lateral = 0;             // [N] on the rail, downwards and outwards positive
};

// `u`: displacements in state layout, the wheelset's in bases turned by `rotation`, which `turned` is of as well.
ClosedContact evaluateContact(const model::Model& model, const model::TurnedStations& turned, const double* u,
                              double wheelX, double rotation);
// Subtracts what the closed points resist with.
void addContactForces(const ClosedContact& closed, double* r);
double storedEnergy(const ClosedContact& closed);  // [J]
void describePatch(const ClosedContact& closed, Equilibrium& e);

// How far the rigid wheel overlaps the rigid rail [m]; negative where its tread has less than the nominal radius.
double rigidOverlap(const model::Model& model, double wheelX, double rotation);

}  // namespace squat::statics
