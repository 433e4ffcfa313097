// solver/case/CaseDescription.h - what the user asked for: plain structs, SI units, no behaviour.
// Names, units, defaults, ranges and documentation of every member stand in the parameter table (ParameterTable.h) and
// only there: a default-constructed CaseDescription is all zeros; start from defaultCase().
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenario/DefectZone.h"
#include "scenario/Scenario.h"
#include "scenario/TrackCentre.h"

namespace squat::cases {

// The parts of a case are those of the scenario that it is resolved into (Resolve.h).
using scenario::Contact;
using scenario::Damping;
using scenario::Defect;
using scenario::defectHeight;
using scenario::DefectShape;
using scenario::DefectSurface;
using scenario::DefectZone;
using scenario::defectZone;
using scenario::ElementPrecision;
using scenario::ForcePoint;
using scenario::Hardening;
using scenario::HeightAndSlope;
using scenario::Irregularity;
using scenario::IrregularityKind;
using scenario::IrregularSurface;
using scenario::LateralShape;
using scenario::Material;
using scenario::MeshPreset;
using scenario::MeshSizes;
using scenario::ModelExtent;
using scenario::monotoneBetween;
using scenario::Motion;
using scenario::Output;
using scenario::Pad;
using scenario::ProfileCurve;
using scenario::ProfileFilter;
using scenario::ProfileLine;
using scenario::ProfilePoint;
using scenario::Rail;
using scenario::RailEnds;
using scenario::RailSection;
using scenario::rigidWheelPath;
using scenario::Seat;
using scenario::SecondPlace;
using scenario::Sleeper;
using scenario::SleeperRange;
using scenario::sleepersOf;
using scenario::Support;
using scenario::Suspension;
using scenario::Track;
using scenario::trackCentre;
using scenario::TreadDeviation;
using scenario::TreadShape;
using scenario::WavelengthLevel;
using scenario::Wheelset;

struct CaseDescription : scenario::Inputs {
  std::string title;
  std::string note;
  // Where values came from (InputPresets.h); they stand in the other members.
  std::string wheelsetPreset, trackPreset, railPreset;
  Defect defect;
  TreadShape tread;
  // What differs on the right side of a whole model (RightSide.h): keys, and values as a case file states them.
  std::vector<std::pair<std::string, std::string>> right;
};

}  // namespace squat::cases
