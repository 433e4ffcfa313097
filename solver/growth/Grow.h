// solver/growth/Grow.h - a defect under many passages: wear and plastic flow change the rail, the rail changes how the
// next wheels roll.
//
// Block by block. All wheelsets of the traffic roll over the rail as it is, one after the other, each leaving its wear
// and its plastic strain: their mean is the rate per passage. A block of N wheelsets changes the shape by N times the
// rate; then all roll again, and the mean of the rates at both ends of the block corrects the change (Heun's method).
// The correction is taken as the error of the block: it is about twice the difference between a whole block and two
// halves. It decides on the length of the next, and a block with too large an error is discarded and shortened.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Monitor.h"
#include "growth/GrowthState.h"
#include "growth/Traffic.h"

namespace squat::growth {

inline constexpr double kilogramsInMegatonne = 1e9;
inline constexpr double tonnageRounding = 1e-6;  // of a tonnage: so near a grinding or the end counts as there

struct Grinding {
  double depth = 0, tonnage = 0;  // [m] taken off, [kg] when
};

struct Growth;

struct GrowthOptions {
  double tonnage = 0;                // [kg] to go to
  std::optional<double> untilDepth;  // [m] of the dip where it ends earlier
  std::vector<Grinding> grindings;   // by tonnage
  int threads = 0;                   // 0: all cores
  std::string isa;                   // empty: the best this processor has
  std::string checkpoint;            // path; empty: none
  bool resume = false;
  std::function<void(const Stage&)> finishedStage;  // on the computing thread
  // The same with all stages so far, those of a checkpoint included; its copies cost memory and little time.
  std::function<void(const Growth&)> soFar = {};
};

struct Growth {
  cases::CaseDescription description;  // as it was rolled: with its zone
  std::vector<Draw> traffic;
  std::vector<double> speeds, wheelLoads;  // [m/s], [N] of each
  std::vector<double> x, y;                // [m] of the nodes
  double bandHalfWidth = 0;                // [m] mesh.band_half_width as the case stated it
  double line = 0;                         // [m] y on which the case's own wheel runs
  double massPerPassage = 0;               // [kg]
  std::vector<Stage> stages;               // the first before any traffic
  std::vector<Field> shapes;               // heights of the nodes at each, defect included [m]
  std::vector<double> wear, flow;          // [m] rise of the nodes in the end, by wear and by flow
  std::vector<std::string> warnings;
  double seconds = 0;  // wall time of this call
  bool complete = false, resumed = false;
};

// The case with a mesh that is fine where the defect grows: 50 mm before it and 120 mm behind, where mesh.zone_before
// and mesh.zone_behind do not say otherwise, a fine band as much wider as wheels wander, a run-up of 0.4 m that ends
// before, and a torque that takes 8 ms to grow. Throws CaseError for a zone that does not hold the defect and, on both
// sides, rail on which changes fade out.
cases::CaseDescription growingCase(cases::CaseDescription description);

// What stands so far where it was cancelled (complete == false). Throws CaseError, RunError, FileError.
Growth grow(const cases::CaseDescription& description, const GrowthOptions& options, Monitor& monitor);

// Tonnage [kg] of the last stage at which grinding by `depth` [m] would still have removed all strained steel, counted
// from the last grinding; nothing where none would.
std::optional<double> lastCleanTonnage(const Growth& growth, double depth);

}  // namespace squat::growth
