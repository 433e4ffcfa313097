// solver/results/RunResult.h - everything that a run yields and a result file holds; plain values, SI units.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "results/AnalysedRecord.h"

namespace squat::results {

using signals::Channel;

struct Scalar {
  std::string name, unit, description;
  double value = 0;
};

// Outer surface of all solids, for pictures. Quads are four point indices each.
struct SurfaceMesh {
  std::vector<float> points;        // x, y, z per point [m], in the configuration at the start, wheel included
  std::vector<std::int32_t> quads;  // 4 per quad
  std::vector<std::uint8_t> part;   // per quad: index into partNames
  // "rail", "sleepers", "wheel rim", "wheel body and axle"; names beginning with "wheel" roll. Names ending with " cut"
  // ("rail cut", "wheel cut") are inner faces on the plane y = 0 near the contact, shown only where a picture cuts
  // there.
  std::vector<std::string> partNames;
  // Line segments that stand for springs and dampers (pads, ballast, suspension): 6 floats each.
  std::vector<float> springs;
};

// Fields on the surface points at one instant.
struct SurfaceSnapshot {
  std::string name;                  // "equilibrium", "impact", "frame 012"
  double time = 0, position = 0;     // [s], [m]
  double wheelTravel = 0;            // [m] along x, since the start
  double wheelRotation = 0;          // [rad] since the start, positive in rolling direction
  std::vector<float> displacement;   // 3 per point [m], elastic and rigid part without travel and rotation
  std::vector<float> vonMises;       // per point [Pa]
  std::vector<float> plasticStrain;  // per point, empty where no plasticity
};

// Pressure and traction at the integration points of the patch at one instant.
struct PatchSnapshot {
  std::string name;
  double time = 0, position = 0;
  std::vector<float> x, y;                  // [m] relative to the wheel centre / rail axis
  std::vector<float> pressure;              // [Pa]
  std::vector<float> tractionX, tractionY;  // [Pa] on the rail
  std::vector<std::uint8_t> slipping;       // 0 sticks, 1 slips
  std::vector<float> area;                  // [m2]
  // Of a whole model the right contact at the same instant, which has no other in turn: y and traction_y count from the
  // right rail's axis outwards, as those of the left one do from its own. Null: a half model, or a result of a version
  // that did not store it.
  std::shared_ptr<const PatchSnapshot> right = nullptr;
};

// What plastic flow leaves behind in the unloaded rail; empty where the rail is elastic. Fields of position x depth lie
// on the plane y = 0.
struct PermanentChange {
  std::vector<double> position, lateral;  // [m] along and across the rail
  std::vector<double> height;             // position x lateral: change of the running surface [m], down negative
  std::vector<double> depth;              // [m] below the running surface
  std::vector<double> equivalentStrain;   // position x depth: equivalent plastic strain
  std::vector<double> stressAlong, stressAcross, stressVertical, vonMises;  // position x depth: residual stress [Pa]

  bool empty() const { return position.empty(); }
};

struct WheelsetMode {
  double frequency = 0;         // [Hz]
  double boxAmplitude = 0;      // vertical mass-normalised amplitude at the axle box [1/sqrt(kg)]
  double wheelAmplitude = 0;    // the same at the wheel centre
  double contactAmplitude = 0;  // the same at the contact point
};

// A run is a record, time from 0 at the start of rolling and position of the wheel centre from the deepest point of the
// defect, with what only a computation knows beside it. Its signals are the rows of simulation/Signals.cpp.
struct RunResult : AnalysedRecord {
  std::string caseToml;  // every default filled in; caseHash is its hash
  // caseToml as read, once, when the result was made or read. None where there is no case, as in a measured record, or
  // where this version cannot read it: then caseProblem says why.
  std::shared_ptr<const cases::ResolvedCase> resolvedCase;
  std::string caseProblem;
  // Datasets of the file that this version does not know, and the version that has written them: what a newer program
  // added within one schema. Empty: all of the file is here.
  std::string notRead;
  std::string codeVersion;
  std::string commit;  // that the program was built from, core/ProgramVersion.h; empty: not known
  std::string isa;     // instruction set of the operator
  int threads = 0;
  std::string created;  // UTC, ISO 8601

  std::vector<double> profilePosition, profileHeight, wheelPath;  // [m]: defect and the path of a rigid wheel over it

  std::vector<double> energyTime;
  std::vector<Channel> energy;      // kinetic, strain, contact, friction, damping, plastic, external, residual
  std::vector<Scalar> equilibrium;  // contact_force, half_axis_rolling, half_axis_lateral, peak_pressure, approach, ...
  std::vector<Scalar> meshFigures;  // elements, nodes, smallest_jacobian, largest_aspect, stable_step, ...
  std::vector<Scalar> performance;  // steps, seconds, element_updates_per_second, peak_memory, phases ...
  std::vector<Scalar> features;     // peak, wavelength_by_ridge, ...: analysis::featureScalars; empty: record too short
  std::vector<Scalar> plasticity;   // largest_equivalent_strain, yielded_elements, ...; empty where the rail is elastic
  PermanentChange permanent;
  std::vector<WheelsetMode> modes;
  std::vector<std::string> warnings;

  SurfaceMesh surface;
  std::vector<SurfaceSnapshot> snapshots;
  std::vector<PatchSnapshot> patches;
};

// Makes a case that of a result: its text, its hash and what it is resolved into.
void setCase(RunResult& result, const cases::CaseDescription& description);
// Reads result.caseToml into resolvedCase or caseProblem; opens no file.
void readCaseOf(RunResult& result);
// The case of a result. Throws FileError where it carries none that this version can read.
const cases::ResolvedCase& caseOf(const RunResult& result);

}  // namespace squat::results
