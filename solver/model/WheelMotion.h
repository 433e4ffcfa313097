// solver/model/WheelMotion.h - mean motion of rings of the turning wheelset in the plane of rolling, and forces on
// them.
#pragma once

#include <utility>
#include <vector>

#include "model/Model.h"

namespace squat::model {

struct PlaneVector {
  double x = 0, z = 0;
};

// Sine and cosine of the spatial angle of every station of the wheel body when it has turned by `rotation`.
struct TurnedStations {
  std::vector<double> sine, cosine;
};
void turnStations(const elasticity::SweptBlock& body, double rotation, TurnedStations& turned);

// Weighted mean of a state (displacement, velocity, ...) over a ring, in x and z.
PlaneVector ringMean(const Model& model, const Ring& ring, const TurnedStations& turned, const double* state);

// Adds a force in the plane, spread over the ring, to a force buffer.
void addRingForce(const Model& model, const Ring& ring, const TurnedStations& turned, PlaneVector force,
                  double* forces);

// Fills the mean motion of the bearing's seat on the journal into a state (displacement, velocity, ...).
void followJournal(const Model& model, const TurnedStations& turned, double* state);

// The ring's mean motion along a direction as a sum over unknowns.
std::vector<std::pair<std::size_t, double>> ringTerms(const Model& model, const Ring& ring,
                                                      const TurnedStations& turned, PlaneVector direction);

// The ring's mean motion along its axis, outwards, the same at any rotation; as a sum over unknowns; and a force along
// it, spread over the ring.
double ringLateralMean(const Model& model, const Ring& ring, const double* state);
std::vector<std::pair<std::size_t, double>> ringLateral(const Model& model, const Ring& ring);
void addRingLateralForce(const Model& model, const Ring& ring, double force, double* forces);

// Turns the wheelset's displacements or forces from bases of rotation zero into those turned by `rotation`.
void turnBases(const Model& model, double rotation, AlignedVector& state);

// Mean turn of the wheelset about its axis in a state, sum of m r u_alpha over the inertia [rad]; of velocities
// [rad/s].
double meanRotation(const Model& model, const double* state);
// Subtracts a rigid turn from the wheelset's displacements or velocities.
void removeMeanRotation(const Model& model, double rotation, double* state);

}  // namespace squat::model
