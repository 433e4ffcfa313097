// solver/statics/SectionShapes.h - how a section bends and stretches in its own plane.
#pragma once

#include <vector>

#include "elasticity/SweptBlock.h"
#include "geometry/SectionMesh.h"

namespace squat::statics {

// In-plane displacements (b, c) of the nodes of a section, the largest of them 1.
using SectionShape = std::vector<geometry::Point2>;

// The `count` softest shapes of a free section beyond its three rigid motions: the lowest natural shapes of a slice of
// unit thickness under plane strain. Of a rail these are the bending web, with the head leaning over the foot, and
// tips of the foot that bend up or down.
std::vector<SectionShape> softestShapes(const elasticity::SweptBlock& block, int count);

}  // namespace squat::statics
