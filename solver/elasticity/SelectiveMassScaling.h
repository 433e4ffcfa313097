// solver/elasticity/SelectiveMassScaling.h - more inertia for waves as short as the elements, none for longer ones.
//
// The explicit step is limited by waves of a few elements' length, at hundreds of kilohertz, which no axle box feels.
// Selective mass scaling (Olovsson, Simonsson and Unosson 2005) slows those alone. Here it acts on the inverse mass
// (reciprocal masses: Tkachuk and Bischoff 2015), so that nothing is to be solved: accelerations are F M^-1 f with
//   F = share 1 + (1 - share) P   within small blocks of nodes, P the projection, orthogonal in the mass, on what is
// constant or linear across and along the block. Rigid motion and uniform strain of a block keep their inertia,
// resultants and moments of forces act as before, stiffness and statics are untouched; what bends within a block is
// 1 / share times as heavy: M_e = M F^-1. A block is a cluster of section nodes on 16 stations that follow each other,
// on eight where 16 are not of one length, on one where the intervals are long.
// Masses of a block may grow, as under closed contact (D, diagonal): with P orthogonal in M + D the effective mass
// becomes at least M_e + D, for x.M_e x = x.M x + (1 / share - 1) min_c |x - B c|^2 in the norm of M, B what is kept.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "elasticity/SweptKernel.h"

namespace squat::elasticity {

struct SweptBlock;

constexpr double shortShare = 0.1;  // of their inverse mass that short waves keep

struct SelectiveMassScaling {
  double share = 1;                     // of the inverse mass that short waves keep
  std::vector<KernelCluster> clusters;  // places of the kernels' order
  // Per place: (1 - share) times its weights in the amplitudes of three fields, then the fields' values there.
  std::vector<double> weights;
  std::vector<float> singleWeights;
  // Per run: what is kept along the sweep (projectionLocation); empty where blocks are one station long.
  std::vector<std::vector<double>> along;
  std::vector<std::vector<float>> singleAlong;
};

// What the projection of a cluster keeps, one field a column: constant, and linear in both coordinates of the section,
// orthonormal in `mass` (per section node): sum of m p q. A field that the others hold (nodes in one line) is zero.
Eigen::MatrixXd keptFields(const SweptBlock& block, const std::vector<int>& cluster, const std::vector<double>& mass);

// Stations that share their inertia with this one.
struct StationGroup {
  int first = 0, count = 1;
};
StationGroup stationGroup(const SweptBlock& block, int station);

// The filter of `stations` stations whose masses are any: `mass` [node of the cluster][station]. Fills `values` with
// what KernelFilter asks for.
void blockFilter(const SweptBlock& block, const std::vector<int>& cluster, int stations,
                 const std::vector<double>& mass, std::vector<double>& values);

// From the block's clusters, shortLength, masses and order.
SelectiveMassScaling selectiveMassScaling(const SweptBlock& block);

// M^-1 f of every node and station, in state layout from the block's first value, becomes F M^-1 f. Plain, for the
// stable step and tests; the kernels do the same while they step.
void slowShortWaves(const SweptBlock& block, double* acceleration);

// The same of one station by itself: nodes x 3.
void scaleMassAcross(const SweptBlock& block, double* acceleration);

}  // namespace squat::elasticity
