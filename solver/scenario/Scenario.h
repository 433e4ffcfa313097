// solver/scenario/Scenario.h - what is simulated: plain SI values, every default filled in, the defect as a surface.
//
// Made once from what a user wrote, cases::resolve(); whoever computes sees this or a part of it.
// Axes of the whole program: x along the track in rolling direction, y lateral (outwards from the track centre),
// z up. The deepest point of the defect is at x = 0; y = 0 and z = 0 are the middle of the rail's running surface.
#pragma once

#include "scenario/DefectSurface.h"
#include "scenario/Growth.h"
#include "scenario/Irregularity.h"
#include "scenario/MeshSizes.h"
#include "scenario/ModelExtent.h"
#include "scenario/Motion.h"
#include "scenario/Output.h"
#include "scenario/Track.h"
#include "scenario/TreadDeviation.h"
#include "scenario/Vehicle.h"

namespace squat::scenario {

// The profile as a term of the gap between wheel and rail, or the surface nodes of the rail moved.
enum class DefectModel { gapFunction, movedNodes };

// What a user writes and what is simulated alike.
struct Inputs {
  ModelExtent extent = ModelExtent::half;
  Track track;
  Rail rail;
  Pad pad;
  Sleeper sleeper;
  Support ballast;
  Wheelset wheelset;
  Suspension suspension;
  Bogie bogie;
  Motion motion;
  Contact contact;
  Damping damping;
  MeshSizes mesh;
  Output output;
  Growth growth;
};

struct Scenario : Inputs {
  DefectSurface defectSurface{Defect{}};
  DefectModel defectModel = DefectModel::gapFunction;
  TreadDeviation tread;
  IrregularSurface irregularity;             // of the rail, always a term of the gap
  IrregularSurface irregularityUnderSecond;  // the same rail, level where the second wheelset stands at the start
};

}  // namespace squat::scenario
