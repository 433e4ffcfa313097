// Relations of a bogie's keys.
#include <cmath>

#include "case/CaseRelations.h"
#include "case/Findings.h"
#include "scenario/TrackCentre.h"

namespace squat::cases::relations {

// The second wheelset rolls on rail that it has to itself, away from its ends.
void checkBogie(const CaseDescription& c, std::vector<Finding>& findings) {
  if (!c.bogie.hasSecond()) return;
  constexpr double apart = 0.5;  // [m] between the stretches that both roll over: room for the mesh to change
  const double rolled = c.motion.runUp + c.motion.beyond;
  if (c.bogie.wheelbase < rolled + apart)
    add(findings, c, Severity::problem, {"bogie.wheelbase", "motion.run_up", "motion.beyond"},
        limitText("bogie.wheelbase", "0 (a single wheelset) or at least", rolled + apart),
        "The wheelsets roll over stretches of their own: shorten motion.run_up or motion.beyond");
  const double fromEnd = 1.5 * c.track.sleeperSpacing;
  const double centre = trackCentre(c.track, c.motion), offset = c.bogie.offset();
  const double reach =
      std::max(std::abs(-c.motion.runUp + offset - centre), std::abs(c.motion.beyond + offset - centre));
  if (reach + fromEnd > 0.5 * c.track.length)
    add(findings, c, Severity::problem, {"track.length", "bogie.wheelbase", "motion.run_up", "motion.beyond"},
        limitText("track.length", "at least", 2 * (reach + fromEnd)),
        "The second wheelset needs rail on all of its way, and one and a half sleeper spacings beyond it");
}

}  // namespace squat::cases::relations
