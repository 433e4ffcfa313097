// widgets/scene/SecondWheelset.h - the other wheelset of a bogie in pictures. It has no mesh and no stress: what is
// drawn are the outlines of the first one at its place, as it turns, without displacements.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "scene/SceneParts.h"

namespace squat::scene {

inline constexpr const char* kSecondWheelset = "grey lines: second wheelset (not meshed)";

// [m] along the rail from the first wheelset to it, negative where it comes behind; 0: there is none, or the case of
// the result cannot be read.
double secondWheelsetFrom(const results::RunResult& result);

// None where there is no second wheelset. `snapshot` may be null: the configuration at the start. Of `look` the width
// of lines and the cuts count.
std::vector<vtkSmartPointer<vtkActor>> secondWheelsetActors(const results::RunResult& result,
                                                            const results::SurfaceSnapshot* snapshot, const Look& look);

// How much a view of both wheelsets sees [m], from its middle half-way between them to its upper edge, where a view of
// the first one alone sees `reach`: enough for a picture that is nearly as wide as high.
double reachOfBoth(double reach, double secondFrom);

}  // namespace squat::scene
