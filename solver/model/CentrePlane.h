// solver/model/CentrePlane.h - the plane at the track centre, where a half model ends.
//
// Each half is described in its own axes: x along the track, y outwards, z up, so that a half and its mirror image are
// one model. Halves that move alike are symmetric; halves that move oppositely, antisymmetric. Any motion of the whole
// is a sum of the two, left = s + a, right = s - a. At the centre plane the halves are one body: there x and z of s
// and y of a are all that is left.
#pragma once

#include <array>
#include <vector>

#include "model/Centre.h"
#include "model/Model.h"

namespace squat::model {

// 1 for each of the three unknowns of a node that may move, 0 for one that the centre plane holds.
std::vector<double> centreMask(const scenario::Wheelset& wheelset, const elasticity::SweptBlock& body, Centre centre);

// Fixes what rail ends, centre plane and fixed sleepers hold; replaces what was fixed before.
void fixUnknowns(Model& model, Centre centre);
// Of one sleeper.
void fixSleeper(Model& model, const elasticity::SweptBlock& sleeper, Centre centre);

// Whether a motion of the one model may be added to one of the other, unknown by unknown: as both halves of one need
// it.
bool haveLikeUnknowns(const Model& a, const Model& b);

// Nodes of a block in the centre plane; `sign` of each component: 1 where both halves move alike, -1 where oppositely.
struct CentreNodes {
  int block = 0;
  std::vector<int> nodes;
  std::array<double, 3> sign{1, 1, 1};
};
CentreNodes axleCentre(const Model& model);                // all around the axis, at every station
CentreNodes sleeperCentre(const Model& model, int block);  // at station 0

// Gives these nodes of both halves the motion that is theirs together: the mean, since both have the same mass.
// Stations from `first` to one before `end`.
void joinAtCentre(const elasticity::SweptBlock& block, const CentreNodes& centre, int first, int end, double* left,
                  double* right);
// Copies what these nodes have at station 0 to the ghost station of a closed block.
void copyToGhost(const elasticity::SweptBlock& block, const CentreNodes& centre, double* state);

}  // namespace squat::model
