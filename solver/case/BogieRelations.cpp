// Relations of a bogie's keys.
#include <algorithm>
#include <cmath>

#include "case/CaseRelations.h"
#include "case/Findings.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "scenario/TrackCentre.h"

namespace squat::cases::relations {

namespace {

// Both roll over stretches of their own, with room between them for the mesh to change.
void checkStretches(const CaseDescription& c, std::vector<Finding>& findings) {
  constexpr double between = 0.5;  // [m]
  const double room = between + c.mesh.fineStart, least = c.motion.runUp + c.motion.beyond + room;
  if (c.bogie.wheelbase >= least) return;
  const double longest = findParameter("bogie.wheelbase")->maximum;
  const std::string why = "The wheelsets roll over stretches of their own: ";
  if (least <= longest)
    add(findings, c, Severity::problem, {"bogie.wheelbase", "motion.run_up", "motion.beyond", "mesh.fine_start"},
        limitText("bogie.wheelbase", "0 (a single wheelset) or at least", least),
        why + "lengthen it, or shorten motion.run_up or motion.beyond");
  else
    add(findings, c, Severity::problem, {"motion.run_up", "motion.beyond", "bogie.wheelbase", "mesh.fine_start"},
        limitText("motion.run_up", "at most", longest - room - c.motion.beyond),
        why + "shorten it or motion.beyond, with bogie.wheelbase up to " + rounded(longest) + " m");
}

// The defect is felt by the first wheelset alone.
void checkDefectLiesOutside(const CaseDescription& c, double from, double to, std::vector<Finding>& findings) {
  const auto surface = surfaceOf(c);
  if (surface.first() == surface.last() || surface.last() < from || surface.first() > to) return;
  add(findings, c, Severity::problem, {"bogie.wheelbase", "defect.points", "defect.length"},
      "such that the second wheelset rolls beside the defect",
      "The defect reaches from " + rounded(surface.first()) + " to " + rounded(surface.last()) +
          " m, the second wheelset rolls from " + rounded(from) + " to " + rounded(to) +
          " m: take a stretch of the profile with defect.from and defect.to");
}

}  // namespace

void checkBogie(const CaseDescription& c, std::vector<Finding>& findings) {
  if (!c.bogie.hasSecond()) return;
  checkStretches(c, findings);
  const double from = c.bogie.offset() - c.motion.runUp, to = c.bogie.offset() + c.motion.beyond;
  checkDefectLiesOutside(c, from, to, findings);
  const double fromEnd = 1.5 * c.track.sleeperSpacing, centre = trackCentre(c.track, c.motion);
  const double reach = std::max(std::abs(from - centre), std::abs(to - centre));
  if (reach + fromEnd > 0.5 * c.track.length)
    add(findings, c, Severity::problem, {"track.length", "bogie.wheelbase", "motion.run_up", "motion.beyond"},
        limitText("track.length", "at least", 2 * (reach + fromEnd)),
        "The second wheelset needs rail on all of its way, and one and a half sleeper spacings beyond it");
}

}  // namespace squat::cases::relations
