// tests/verification/SectionFlexibility.h - how much a section gives way across itself between its mean and a pad.
#pragma once

#include <vector>

#include "case/CaseDescription.h"
#include "geometry/SectionMesh.h"

namespace squat::verification {

// A slice of the rail in plane strain that stands on the pad's springs, loaded by its own inertia (a force even over
// its area, the conjugate of its mean displacement): mean vertical displacement for 1 N a metre, less that of the
// springs alone [m2/N]. Quadrilaterals with incompatible modes (R. L. Taylor, P. J. Beresford, E. L. Wilson 1976).
// `springs`: places across [m] of springs that share `stiffness` [N/m2] evenly under the lowest nodes.
double footFlexibility(const geometry::SectionMesh& section, const scenario::Material& material,
                       const std::vector<double>& springs, double stiffness);

}  // namespace squat::verification
