// solver/scenario/ScenarioDeclaration.h - the names of what is simulated, for headers that only hand it on.
#pragma once

namespace squat::scenario {

class DefectSurface;
class IrregularSurface;
class TreadDeviation;
struct ForcePoint;
struct ProfileLine;
struct ProfilePoint;
struct Rail;
enum class RailSection;
struct Scenario;
struct Seat;
struct Wheelset;

}  // namespace squat::scenario
