// widgets/scene/SurfaceData.h - surface and snapshot as VTK data, in the place that they have at that instant.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

#include "results/RunResult.h"
#include "scene/Field.h"

namespace squat::scene {

// Parts whose names begin with "wheel" roll: wheelTravel and wheelRotation apply to them. Parts whose names end with
// " cut" are inner faces on the plane y = 0, shown only where the picture is cut there.
bool rolls(const std::string& partName);
bool isCutFace(const std::string& partName);

// Centre of the wheel at the start: the middle in x and z of the rolling parts; zeros where there are none.
std::array<double, 3> wheelCentre(const results::SurfaceMesh& surface);

// Whether both sides of the track are there: the half model's surface ends at the track centre.
bool hasBothSides(const results::SurfaceMesh& surface);
// Middle of the track or, of a half model, a place between rail and track centre [m].
double middleAcross(const results::SurfaceMesh& surface);

struct PartData {
  std::string name;
  vtkSmartPointer<vtkPolyData> faces;  // point scalars: the field in the unit of fieldName(), if any
};

// Where every point is at the instant of the snapshot [m]: rolled, and displaced times `displacementScale`; 3 a point.
std::vector<float> locationsOf(const results::SurfaceMesh& surface, const results::SurfaceSnapshot& snapshot,
                               double displacementScale);

// Largest value of the field in the unit of fieldName(), among points of faces within `reach` [m] of the contact along
// the rail, at the instant of the snapshot; of a whole model of both contacts, so that colours stand for the same
// values on both sides and in every picture. 0 for fields of the patch.
double largestNearContact(const results::SurfaceMesh& surface, const results::SurfaceSnapshot& snapshot, Field field,
                          double reach);

// One entry a part that has faces. `snapshot` may be null: configuration at the start, no field.
// Displacements are multiplied by `displacementScale`. Broken indices are left out.
std::vector<PartData> partData(const results::SurfaceMesh& surface, const results::SurfaceSnapshot* snapshot,
                               Field field, double displacementScale);

// Springs as zigzag lines. Springs that touch no rolling part stay; those above the rail's top travel with the wheel.
vtkSmartPointer<vtkPolyData> springLines(const results::SurfaceMesh& surface, double wheelTravel);

}  // namespace squat::scene
