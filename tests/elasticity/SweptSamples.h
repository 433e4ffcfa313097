// tests/elasticity/SweptSamples.h - small swept blocks and a plain assembly to judge the swept operator by.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <functional>
#include <string>
#include <vector>

#include "core/AlignedVector.h"
#include "elasticity/SweptBlock.h"
#include "elasticity/SweptTie.h"

namespace squat::elasticity {

using Field = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

inline const scenario::Material steel{210e9, 0.3, 7800};

// n + 1 equally spaced values.
std::vector<double> evenly(double from, double to, int n);

// Quads between all pairs of lines; `skew` moves inner nodes by that share of the smallest step, in a fixed pattern.
geometry::SectionMesh gridSection(const std::vector<double>& b, const std::vector<double>& c, double skew = 0);

// A closed ring of 0.3 to 0.4 m with fine and coarse sectors, not prepared yet.
SweptBlock ringBlock();

// Prepares the blocks and places them one behind the other in the state; returns the state's size.
std::size_t layOut(std::vector<SweptBlock>& blocks);

// Sets the block's part of a state to a displacement field given in global axes, ghost station included.
void setField(const SweptBlock& block, const Field& field, AlignedVector& state);

// Displacement of a node in global axes.
Eigen::Vector3d displacementAt(const SweptBlock& block, int node, int station, const AlignedVector& state);

// K u by the swept kernels, cut into `parts` stretches that are worked off one after the other.
AlignedVector applySwept(const std::vector<SweptBlock>& blocks, const AlignedVector& u, const std::string& isa,
                         int parts = 1, Precision precision = Precision::doubleInside);

// Adds what the slaves feel in `from` to the masters in `to` (both state layout), by the given cuts between ranges of
// master stations; none: in one go.
void passToMasters(const SweptTie& tie, const std::vector<SweptBlock>& blocks, const AlignedVector& from,
                   AlignedVector& to, const std::vector<int>& cuts = {});

// The sum of the elements' matrices, each made from its eight corners in global axes and turned node by node into the
// local components: nothing of the sweep is used but the nodes' places. Unknowns numbered as in the state.
Eigen::SparseMatrix<double> plainMatrix(const std::vector<SweptBlock>& blocks, std::size_t size);

// State index of every unknown that is no ghost and no padding.
std::vector<std::size_t> unknownsOf(const SweptBlock& block);

// Stress at the centre of an element in global axes (xx, yy, zz, xy, yz, zx).
Eigen::Matrix<double, 6, 1> centreStress(const SweptBlock& block, int quad, int interval, const AlignedVector& state);

// The six rigid motions as fields: three translations of 1 m, three small rotations of 1 rad about the origin.
std::vector<Field> rigidMotions();

double largest(const AlignedVector& values);

}  // namespace squat::elasticity
