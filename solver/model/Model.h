// solver/model/Model.h - the assembled system: solids, ties, springs, masses, contact surfaces. No time in it.
//
// State layout: the lines of block 0, block 1, ... and at the end the auxiliary degrees of freedom: sprung mass along x
// and z, axle box along x and z where its bearing is a spring (a rigid bearing spreads the box over its seat on the
// journal), and the mean motion of the bearing's seat on the journal along x and z. The latter depends on the wheel
// body and on its rotation as a slave does on its masters: whoever walks the force elements fills it first
// (followJournal) and passes its forces on to the seat. Displacements are relative to a reference that moves with the
// vehicle's speed and, for the wheelset, turns with its mean rotation; components are local to each block
// (SweptBlock.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/ContactSurfaces.h"
#include "core/AlignedVector.h"
#include "elasticity/IrregularElements.h"
#include "elasticity/SweptBlock.h"
#include "elasticity/SweptTie.h"
#include "forces/ForceElements.h"
#include "model/SecondWheelset.h"
#include "plasticity/SurfaceLayer.h"
#include "scenario/Scenario.h"

namespace squat::model {

// Nodes of a block on which forces act besides the elasticity: each has a triple of force lines.
struct LoadedNodes {
  std::vector<int> lineOfNode;  // per section node: triple index or -1
  int count = 0;
  std::size_t offset = 0;  // of the block's triples in the force buffer
};

// A set of wheelset nodes all around the axis whose mean motion counts: bearing seat, hub.
struct Ring {
  int block = 0;
  std::vector<int> nodes;
  std::vector<double> weight;  // per node, sums to 1 over all nodes and stations when divided by the station count
};

struct WheelsetFigures {
  double inertia = 0;  // [kg m2] about the axis, everything that turns
  // [kg m] sum of m r e_alpha in x and z before anything has turned, and [kg] of m: masses lumped at stations of
  // different distances are not quite in balance.
  double leverX = 0, leverZ = 0, turningMass = 0;
  double mass = 0;          // [kg] solids, axle box and discs
  double solidMass = 0;     // [kg] as meshed
  double centreHeight = 0;  // [m] of the axis above the running surface
};

struct Model {
  scenario::Scenario scenario;
  std::vector<elasticity::SweptBlock> blocks;
  int rail = -1, rim = -1, body = -1, firstSleeper = -1, sleepers = 0;
  std::vector<double> sleeperPositions;  // [m] along x
  std::vector<elasticity::SweptTie> ties;
  elasticity::IrregularElements movedElements;  // of the rail, under a defect whose nodes are moved
  // What the unequal height of a sleeper adds to the operator: all are alike, unknowns and force slots count from the
  // sleeper's own first ones. Empty: even height.
  elasticity::IrregularElements sleeperShape;
  plasticity::SurfaceLayer layer;                 // of the rail head; empty where nothing may yield
  std::vector<std::vector<unsigned char>> slave;  // per block and section node
  std::vector<std::vector<double>> freeMask;      // per block: nodes x 3, 0 where a whole line is fixed
  std::vector<std::size_t> fixed;                 // single unknowns that are fixed
  std::vector<LoadedNodes> loaded;                // per block
  std::size_t stateSize = 0, forceSize = 0;
  std::size_t sprungX = 0, sprungZ = 0;    // state indices of the auxiliary degrees of freedom
  std::size_t boxX = 0, boxZ = 0;          // only where boxOnSpring()
  std::size_t journalX = 0, journalZ = 0;  // dependent
  std::size_t firstAuxiliary = 0;
  bool boxOnSpring() const { return scenario.wheelset.bearingStiffness > 0; }

  std::vector<AlignedVector> mass;         // per block: nodes x stride [kg], ties passed on, boxes and discs added
  std::vector<AlignedVector> inverseMass;  // 0 for slaves and padding
  std::vector<forces::ForceElements> forceElements;
  Ring bearing, hub, centre;  // centre: the ring that stands for the wheel centre
  WheelsetFigures wheelset;
  contact::Surfaces surfaces;
  double startX = 0;                     // [m] wheel position at the start
  std::optional<SecondWheelset> second;  // of a bogie

  std::size_t elements() const;
  std::size_t nodeCount() const;  // without slaves counted twice
};

// Builds everything from the case. Throws CaseError where the mesh cannot carry the case.
// `sleeperIntervals` along a half sleeper, a multiple of 8; 0: as the mesh preset has it.
Model buildModel(const scenario::Scenario& scenario, int sleeperIntervals = 0);

// One bay of a track that repeats itself, its sleeper in the middle at x = 0, the rail cut at midspan on both sides:
// rail, sleeper, pads and ballast, no wheelset. Stations at most `stationLength` [m] apart; seats that differ are left
// out.
Model buildTrackCell(const scenario::Scenario& scenario, double stationLength, int sleeperIntervals);

// The model of another case that differs in its defect alone, a term of the gap function in both (no nodes moved), on a
// mesh for the same zone (scenario/DefectZone.h): as buildModel() makes it, in the time of a copy.
Model withDefect(Model model, const scenario::Scenario& scenario);

// Block, node, station and position of a state index, for messages.
std::string locationName(const Model& model, std::size_t index);

// The same of an element of a block.
std::string elementLocation(const elasticity::SweptBlock& block, int quad, int interval);

// The part of the track or vehicle in words of its user with the keys of the case that give its elements their size,
// those that shape the part before those of the mesh.
std::string partName(const Model& model, std::size_t index);

// result += K u of what the height of the sleepers changes in the swept operator (state layout).
void addSleeperShapes(const Model& model, const double* u, double* result);

// Mesh quality: smallest Jacobian ratio, largest aspect ratio, and where.
struct MeshQuality {
  double smallestJacobian = 1, largestAspect = 1;
  std::string jacobianLocation, aspectLocation;
};
MeshQuality meshQuality(const Model& model);

}  // namespace squat::model
