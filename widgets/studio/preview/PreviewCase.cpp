#include "studio/preview/PreviewCase.h"

#include <algorithm>
#include <cmath>

#include "case/MeshPresets.h"
#include "case/Resolve.h"

namespace squat::studio {
namespace {

constexpr double zoneStep = 0.04;           // [m]
constexpr double rolledBehindDefect = 0.1;  // [m] from its deepest point
constexpr double rolledBehindLast = 0.04;   // [m] from the end of a long one
constexpr double minimumApproach = 0.06;    // [m] from the start to the zone
constexpr double roomToStart = 0.03;        // [m] the same at least: the patch begins 14 mm ahead of the wheel
constexpr double endMargin = 0.3;           // [m] of rail beyond the run, as cases are checked

double inSteps(double length, double step) { return step * std::ceil(length / step - 1e-9); }

// A profile that is longer than any of the preset's track needs more sleepers.
void lengthenTrack(cases::CaseDescription& description) {
  const auto& motion = description.motion;
  const double half = std::max(motion.runUp, motion.beyond) + endMargin + description.track.sleeperSpacing;
  const double minimum = std::max(2 * half, 5 * description.track.sleeperSpacing);
  if (minimum > description.track.length) description.track.length = inSteps(minimum, description.track.sleeperSpacing);
}

}  // namespace

cases::CaseDescription previewCase(const cases::CaseDescription& open) {
  auto description = open;
  auto& mesh = description.mesh;
  auto& motion = description.motion;
  if (mesh.preset == cases::MeshPreset::tiny) {
    const double runUp = cases::defectZone(description).before + roomToStart;
    if (motion.runUp >= runUp) return description;
    motion.runUp = runUp;
  } else {
    cases::applyPreset(description, cases::MeshPreset::tiny);
    description.output.timeStep = 0;
    const auto surface = cases::surfaceOf(description);
    mesh.zoneBefore = inSteps(std::max(-surface.first(), zoneStep), zoneStep);
    mesh.zoneBehind = inSteps(std::max(surface.last(), zoneStep), zoneStep);
    const auto zone = cases::defectZone(description);
    motion.runUp = std::max(motion.runUp, zone.before + minimumApproach);
    motion.beyond = std::max(rolledBehindDefect, zone.behind + rolledBehindLast);
  }
  lengthenTrack(description);
  return description;
}

std::string whyNoPreview(const cases::CaseDescription& open) {
  if (open.defect.moveNodes)
    return "No preview with defect.move_nodes: moved nodes change the stiffness of the rail, so every profile needs a "
           "whole run.";
  if (open.extent == cases::ModelExtent::whole)
    return "No preview of a whole model: it shows one rail and half the wheelset. Set model.extent to half to see it.";
  const auto surface = cases::surfaceOf(open);
  if (surface.first() == surface.last()) return "No preview of a smooth rail: the case has no defect.";
  return {};
}

}  // namespace squat::studio
