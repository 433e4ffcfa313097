// solver/model/StaticOperator.h - K u of the whole model at one position of the wheel: solids, ties,
// force elements.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "core/ThreadTeam.h"
#include "elasticity/SweptWork.h"
#include "model/Model.h"
#include "model/WheelMotion.h"

namespace squat::model {

// Vectors are in state layout. Slaves, fixed unknowns, ghosts and padding are zero in results; in arguments they are
// written by apply() (slaves and ghosts from their masters).
class StaticOperator {
 public:
  // `rotationStiffness` [N m/rad] fixes the wheelset's mean rotation, which nothing else does without friction; zero
  // leaves it free.
  StaticOperator(const Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team, double rotation,
                 double rotationStiffness, bool fixSprungMassAlong);

  void apply(double* u, double* result);
  // Force elements with an elastic law enter apply() and diagonal() by their tangents: at rest at first, then about a
  // displacement, or the stiffest that they have.
  bool linearise(const double* displacement);  // whether any tangent has changed
  void stiffen();
  // About the displacement that linearise() was given: adds to outer forces what these elements exert besides -K_t u;
  // their stored energy besides u.K_t u / 2.
  void addForcesBesideTangents(double* force) const;
  double energyBesideTangents() const;
  // The caller's: tangent of the closed contact, or dashpots as springs.
  forces::ForceElements& contactSprings() { return contact_; }
  AlignedVector diagonal() const;  // with contact springs; 1 where the unknown is not free
  const std::vector<unsigned char>& freeUnknowns() const { return free_; }
  const TurnedStations& turned() const { return turned_; }
  ThreadTeam& team() { return team_; }

  // Moves forces on slaves to their masters and clears what is not free: r in state layout.
  void reduceForces(double* r);
  void fillSlaves(double* u);

 private:
  void placeTiedNodes(double* u, int index);
  void passTieForces(double* r);
  void addJournalForces(double* r) const;
  void clearNotFree(double* r, int index) const;

  const Model& model_;
  elasticity::KernelSet kernels_;
  ThreadTeam& team_;
  std::vector<std::vector<elasticity::Segment>> work_;
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch_;
  TurnedStations turned_;
  // The dependent auxiliary unknowns, each with the weighted sum that it is.
  std::array<std::pair<std::size_t, std::vector<std::pair<std::size_t, double>>>, 2> journal_;
  // Linear sets of the model, and of the others the tangents.
  std::vector<const forces::ForceElements*> linear_;
  struct Tangents {
    const forces::ForceElements* of = nullptr;
    forces::ForceElements set;                      // linear
    std::vector<double> forceBeside, energyBeside;  // per element [N], [J]
  };
  std::vector<Tangents> tangents_;
  forces::ForceElements rotationStiffness_, contact_;
  std::vector<unsigned char> free_;
  std::vector<std::array<std::size_t, 2>> notFree_;  // stretches of the state: first and one past the last
  std::vector<AlignedVector> tieWorkspaces_;         // per thread
};

// Mean turn of the hub as a sum over unknowns: enough to fix the rotation, whose force is zero in the equilibrium.
std::vector<std::pair<std::size_t, double>> hubTurn(const Model& model);

// Weight of the model in state layout: gravity times mass, z down; the wheelset's at the given rotation.
AlignedVector gravityForces(const Model& model, double rotation);

}  // namespace squat::model
