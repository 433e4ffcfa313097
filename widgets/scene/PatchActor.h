// widgets/scene/PatchActor.h - the contact patch on the rail: pressure, or where it sticks and slips.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

#include "scene/SceneParts.h"

namespace squat::scene {

constexpr std::array<double, 3> stickColour{0.00, 0.45, 0.70}, slipColour{0.90, 0.45, 0.05};

double largestPressure(const results::PatchSnapshot& patch);  // [MPa], of both contacts of a whole model

// Of one contact in its place, the part of the surface that every carrying point stands for, on the surface of the rail
// among `parts`, which stand where they are at that instant; the wheel's centre is at x = `contactAt`. Coloured by
// pressure on the scale of `look`, or by stick and slip where that is the field.
vtkSmartPointer<vtkActor> patchActor(const results::PatchSnapshot& patch, const std::vector<PartData>& parts,
                                     double contactAt, const Look& look);

}  // namespace squat::scene
