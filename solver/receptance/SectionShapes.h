// solver/receptance/SectionShapes.h - the few shapes in which a rail's section moves at low frequencies.
//
// Natural modes of the section in standing waves from 12 m to 0.1 m long, and what it answers to the forces of pads and
// load in such waves: rigid motions, warping, bending of web and foot, local give. Everything else is left out, which
// makes the track a trifle too stiff; the number of shapes says how little.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/Model.h"

namespace squat::receptance {

struct SectionShapes {
  Eigen::MatrixXd shapes;        // columns: unknowns 3 node + component; orthonormal in massPerMetre
  Eigen::VectorXd turn;          // per column: -1 where it moves along the sweep only, +1 where across it only
  std::vector<int> families;     // neighbouring columns that the block's own stiffness does not couple with the others
  Eigen::VectorXd massPerMetre;  // per unknown [kg/m]
};

// `tolerance`: singular values below this share of the largest are left out.
SectionShapes railShapes(const model::Model& model, double tolerance = 1e-3);

// Every unknown of a section by itself.
SectionShapes allShapes(const elasticity::SweptBlock& block);

}  // namespace squat::receptance
