// Torsion of a plane section and the lateral and torsional modes of a free beam that has it: what thin-walled theory
// says, by means that share nothing with the solver but the section's quads.
#pragma once

#include <utility>
#include <vector>

#include "case/CaseDescription.h"
#include "geometry/SectionMesh.h"

namespace squat::verification {

struct TorsionConstants {
  double area = 0, lateralMoment = 0, polarMoment = 0;  // [m2], [m4] about the vertical axis, [m4] about the centroid
  double torsion = 0;                                   // [m4] St Venant's J
  double warping = 0;                                   // [m6] C_w about the shear centre
  double shearCentre = 0, centroid = 0;                 // [m] second coordinate; the section is symmetric in the first
};

// Warping function w of the section (laplace w = 0, natural boundary condition) by bilinear quads, 2x2 Gauss points:
// weak form  int grad f . grad w = int (f_y z - f_z y)  about the centroid,
// J = int (w_y - z)^2 + (w_z + y)^2,  shear centre z_s = int w y / int y^2 above the centroid, C_w = int (w - z_s y)^2.
TorsionConstants sectionTorsion(const geometry::SectionMesh& section);

struct LateralMode {
  double frequency = 0;  // [rad/s]
  double torsion = 0;    // share of the turning about the centroid in the kinetic energy
};

// Lowest elastic modes of a free beam, cubic elements for motion of the shear centre and turn.
std::vector<LateralMode> lateralTorsionModes(const TorsionConstants& section, const scenario::Material& material,
                                             double length, int count);

// A rectangle of quads, and two meshes as one (nodes at the same place merged).
geometry::SectionMesh plate(std::pair<double, double> b, std::pair<double, double> c, int alongB, int alongC);
void join(geometry::SectionMesh& to, const geometry::SectionMesh& other);

}  // namespace squat::verification
