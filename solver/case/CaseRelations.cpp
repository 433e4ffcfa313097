// Relations between keys of a case. The first key of a finding is the one that the user should change.
#include "case/CaseRelations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/DecimalNumber.h"
#include "case/Findings.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/ProfileStretch.h"
#include "case/Resolve.h"
#include "geometry/RailSection.h"
#include "scenario/DefectSurface.h"
#include "scenario/MeasuredProfile.h"
#include "scenario/SleeperHeight.h"
#include "scenario/TrackCentre.h"
#include "scenario/WheelsetMass.h"

namespace squat::cases::relations {

namespace {

constexpr double endMargin = 0.3;  // [m] of rail that must be left beyond the run

using Case = CaseDescription;

// A profile that is longer than any defect is given in another unit, or a scan of which a stretch is meant.
std::string unitHint(const Case& c, const DefectSurface& surface) {
  constexpr double longest = 3;  // [m]; instruments measure 1 to 1.2 m at once
  const double length = surface.last() - surface.first();
  if (c.defect.shape != DefectShape::profile || length <= longest) return {};
  const auto& points = c.defect.lines.empty() ? c.defect.points : c.defect.lines.front().points;
  return ". The profile is " + rounded(length) + " m long: check the unit of its positions, or take a stretch. " +
         stretchAdvice(scenario::countedPoints(points, c.defect));
}

}  // namespace

void checkMaterials(const Case& c, std::vector<Finding>& findings) {
  const bool below = c.rail.tangentModulus < c.rail.material.young;
  if (!below)
    add(findings, c, Severity::problem, {"rail.tangent_modulus", "rail.young_modulus"},
        limitText("rail.tangent_modulus", "below rail.young_modulus =", c.rail.material.young),
        "A material is softer beyond yield");
}

namespace {

void checkWheelsetMass(const Case& c, std::vector<Finding>& findings) {
  const auto& w = c.wheelset;
  const double minimum = scenario::partsMass(w), discs = scenario::brakeDiscsMass(w);
  if (w.totalMass > 0 && w.totalMass < minimum)
    add(findings, c, Severity::problem,
        {"wheelset.total_mass", "wheelset.axle_box_mass", "wheelset.brake_disc_mass", "wheelset.density",
         "wheelset.radius"},
        limitText("wheelset.total_mass",
                  discs > 0 ? "at least the mass of the solid parts, the axle box and the brake discs:"
                            : "at least the mass of the solid parts and the axle box:",
                  minimum),
        "Increase the total mass or make the parts lighter; 0 takes what they weigh, solid parts " +
            rounded(minimum - w.axleBoxMass - discs) + " kg, axle box " + rounded(w.axleBoxMass) + " kg" +
            (discs > 0 ? ", brake discs " + rounded(discs) + " kg" : ""));
  if (w.brakeDiscs > 0 && (w.brakeDiscPosition <= 0.5 * w.hubWidth || w.brakeDiscPosition >= w.trackCentre))
    add(findings, c, Severity::problem, {"wheelset.brake_disc_position", "wheelset.hub_width", "wheelset.track_centre"},
        "between hub and track centre, " + rounded(0.5e3 * w.hubWidth) + " to " + rounded(1e3 * w.trackCentre) + " mm",
        "Brake discs sit on the axle between the hub and the track centre");
}

// Four-point bending: between the wheels the axle carries the load of the axle box times its lever, weakened by the
// bore.
void checkAxleBending(const Case& c, std::vector<Finding>& findings) {
  constexpr double yield = 320e6;  // [Pa] usual for axle steel EA1N (unverified)
  const auto& w = c.wheelset;
  if (!(w.boreRadius < w.axleRadius)) return;
  const double moment = c.suspension.sprungMass * c.motion.gravity * w.bearingCentre;
  const double outer = std::pow(w.axleRadius, 4), inner = std::pow(w.boreRadius, 4);
  const double stress = moment * 4 * w.axleRadius / (std::numbers::pi * (outer - inner));
  if (stress > yield)
    add(findings, c, Severity::warning,
        {"wheelset.axle_radius", "wheelset.bore_radius", "wheelset.bearing_centre", "suspension.sprung_mass"},
        limitText("wheelset.axle_radius", "about", w.axleRadius * std::cbrt(stress / yield)) + " or more",
        "The load bends the axle to " + rounded(1e-6 * stress) + " MPa; axle steel yields at about " +
            rounded(1e-6 * yield) + " MPa, and the model is for small deflections");
}

}  // namespace

void checkWheelset(const Case& c, std::vector<Finding>& findings) {
  const auto& w = c.wheelset;
  struct Order {
    double smaller, larger;
    const char *smallerKey, *largerKey;
    const char* advice;
  };
  const Order orders[] = {
      {w.boreRadius, w.journalRadius, "wheelset.bore_radius", "wheelset.journal_radius",
       "The bore runs through the journal"},
      {w.boreRadius, w.axleRadius, "wheelset.bore_radius", "wheelset.axle_radius", "The bore runs through the axle"},
      {w.boreRadius, w.shoulderRadius, "wheelset.bore_radius", "wheelset.shoulder_radius",
       "The bore runs through the step"},
      {w.journalRadius, w.seatRadius, "wheelset.journal_radius", "wheelset.seat_radius",
       "The axle gets thinner outwards"},
      {w.shoulderRadius, w.hubRadius, "wheelset.shoulder_radius", "wheelset.hub_radius", "The hub sits on the axle"},
      {w.axleRadius, w.hubRadius, "wheelset.axle_radius", "wheelset.hub_radius", "The hub sits on the axle"},
      {w.seatRadius, w.hubRadius, "wheelset.seat_radius", "wheelset.hub_radius", "The hub sits on the wheel seat"},
      {w.hubRadius, w.rimInnerRadius, "wheelset.hub_radius", "wheelset.rim_inner_radius",
       "The web lies between hub and rim"},
      {w.rimInnerRadius, w.radius, "wheelset.rim_inner_radius", "wheelset.radius", "The rim needs a thickness"},
      {w.webThickness, w.hubWidth, "wheelset.web_thickness", "wheelset.hub_width",
       "The web meets the hub within its width"},
      {w.webThickness, w.rimWidth, "wheelset.web_thickness", "wheelset.rim_width",
       "The web meets the rim within its width"},
      {0.5 * w.hubWidth, w.shoulderEnd, "wheelset.hub_width", "wheelset.shoulder_end",
       "The step begins outside the hub"},
      {w.shoulderEnd, w.journalEnd, "wheelset.shoulder_end", "wheelset.journal_end",
       "The journal begins outside that step"},
      {0.5 * w.hubWidth, w.trackCentre, "wheelset.hub_width", "wheelset.track_centre",
       "The hub ends before the symmetry plane"},
  };
  const auto isHalf = [](std::string_view key) { return key == "wheelset.hub_width"; };  // compared by its half
  for (const auto& order : orders)
    if (!(order.smaller < order.larger))
      add(findings, c, Severity::problem, {order.smallerKey, order.largerKey},
          limitText(
              order.smallerKey,
              (std::string(isHalf(order.smallerKey) ? "below twice " : "below ") + order.largerKey + " =").c_str(),
              order.larger * (isHalf(order.smallerKey) ? 2 : 1)),
          order.advice);
  const double hubThickness = w.webHubThickness > 0 ? w.webHubThickness : w.webThickness;
  const double room = 0.5 * (w.hubWidth - hubThickness) - 0.002;  // [m] elements beside the web need a width
  if (room < 0) {
    const char* thickness = w.webHubThickness > 0 ? "wheelset.web_hub_thickness" : "wheelset.web_thickness";
    add(findings, c, Severity::problem, {thickness, "wheelset.hub_width"},
        limitText(thickness, "at most", w.hubWidth - 0.004), "The web meets the hub within its width");
  } else if (std::abs(w.webOffset) > room)
    add(findings, c, Severity::problem, {"wheelset.web_offset", "wheelset.web_hub_thickness", "wheelset.hub_width"},
        "between -" + limitText("wheelset.web_offset", "", room).substr(1) + " and" +
            limitText("wheelset.web_offset", "", room),
        "The web meets the hub within its width");
  if (w.bearingStiffness > 0 && w.axleBoxMass < 1)
    add(findings, c, Severity::problem, {"wheelset.axle_box_mass", "wheelset.bearing_stiffness"},
        limitText("wheelset.axle_box_mass", "at least", 1), "An axle box on a bearing spring needs a mass");
  const double inner = w.bearingCentre - 0.5 * w.bearingWidth, outer = w.bearingCentre + 0.5 * w.bearingWidth;
  constexpr double slack = 1e-9;  // [m] against round-off of the sums
  if (inner < w.shoulderEnd - slack || outer > w.journalEnd + slack)
    add(findings, c, Severity::problem,
        {"wheelset.bearing_centre", "wheelset.bearing_width", "wheelset.shoulder_end", "wheelset.journal_end"},
        "such that the bearing lies on the journal, " + rounded(w.shoulderEnd * 1e3) + " to " +
            rounded(w.journalEnd * 1e3) + " mm",
        "The bearing extends from " + rounded(inner * 1e3) + " to " + rounded(outer * 1e3) +
            " mm: move it, shorten it or lengthen the journal");
  checkWheelsetMass(c, findings);
  checkAxleBending(c, findings);
}

namespace {

void checkSupports(const Case& c, std::vector<Finding>& findings) {
  const auto sleepers = c.track.seats.empty() ? SleeperRange{} : sleepersOf(c.track, c.pad, c.motion);
  for (const auto& seat : c.track.seats)
    if (seat.sleeper < sleepers.first || seat.sleeper > sleepers.last)
      add(findings, c, Severity::problem, {"track.seats", "track.length", "track.sleeper_spacing"},
          "sleepers from " + std::to_string(sleepers.first) + " to " + std::to_string(sleepers.last),
          "There is no sleeper " + std::to_string(seat.sleeper) +
              "; 0 is the one nearest to the defect. Count from there or lengthen track.length");
  const auto& curve = c.pad.curve;
  if (!curve.empty() && (c.pad.preload < curve.front().force || c.pad.preload > curve.back().force))
    add(findings, c, Severity::problem, {"pad.preload", "pad.curve"},
        rounded(1e-3 * curve.front().force, Side::above) + " to " + rounded(1e-3 * curve.back().force, Side::below) +
            " kN, the forces of pad.curve",
        "The clamping force must lie on the curve; change it or extend the curve");
}

}  // namespace

namespace {

// The top of a sleeper falls from the pads to its middle; elements there keep a height.
void checkSleeperHeight(const Case& c, std::vector<Finding>& findings) {
  const auto& s = c.sleeper;
  constexpr double minimum = 0.3, rise = 0.02;  // [-] of the height under the rail, [m] of the slope of the top
  if (s.middleHeight == 0) return;
  if (s.middleHeight > s.height)
    add(findings, c, Severity::problem, {"sleeper.middle_height", "sleeper.height"},
        "0 or " + limitText("sleeper.middle_height", "at most sleeper.height =", s.height),
        "A sleeper is highest under the rail");
  if (s.middleHeight < minimum * s.height)
    add(findings, c, Severity::problem, {"sleeper.middle_height", "sleeper.height"},
        "0 or " + limitText("sleeper.middle_height", "at least 0.3 of sleeper.height:", minimum * s.height),
        "Set it to 0 for an even height");
  const double longest = scenario::fullHeightFrom(c) - rise;
  if (s.middleHalfLength > longest)
    add(findings, c, Severity::problem, {"sleeper.middle_half_length", "wheelset.track_centre", "pad.width"},
        limitText("sleeper.middle_half_length", "at most", longest),
        "The top rises between there and the inner edge of the rail pad");
}

}  // namespace

void checkTrackAndRun(const Case& c, std::vector<Finding>& findings) {
  const double half = 0.5 * c.track.length;
  const auto surface = surfaceOf(c);
  if (c.defect.shape == DefectShape::dipWithWave && c.defect.waveCount > 0 && c.defect.waveDepth > c.defect.depth)
    add(findings, c, Severity::problem, {"defect.wave_depth", "defect.depth"},
        limitText("defect.wave_depth", "at most defect.depth =", c.defect.depth),
        "Positions are measured from the dip as the deepest location; describe deeper waves with defect.points");
  if (std::abs(c.track.defectFromSleeper) > 0.5 * c.track.sleeperSpacing)
    add(findings, c, Severity::problem, {"track.defect_from_sleeper", "track.sleeper_spacing"},
        "-" + rounded(0.5 * c.track.sleeperSpacing) + " to " + rounded(0.5 * c.track.sleeperSpacing) + " m",
        "It is measured from the nearest sleeper: at most half of track.sleeper_spacing");
  const double centre = trackCentre(c.track, c.motion);
  const std::string unit = unitHint(c, surface);
  const bool isScan = c.defect.shape == DefectShape::profile && unit.empty();
  const std::string shorter = isScan ? ", or take a stretch of the profile with defect.from and defect.to" : unit;
  if (c.motion.runUp > half - centre - endMargin)
    add(findings, c, Severity::problem, {"motion.run_up", "track.length"},
        limitText("motion.run_up", "at most", half - centre - endMargin),
        "The run starts too close to the end of the rail: increase track.length or shorten the run-up" + unit);
  if (c.motion.beyond > half + centre - endMargin)
    add(findings, c, Severity::problem, {"motion.beyond", "track.length"},
        limitText("motion.beyond", "at most", half + centre - endMargin),
        "The run ends too close to the end of the rail: increase track.length or shorten the run" + unit);
  if (surface.first() < centre - half || surface.last() > centre + half)
    add(findings, c, Severity::problem, {"track.length", "defect.length", "defect.points", "defect.file"},
        limitText("track.length", "at least", 2 * std::max(centre - surface.first(), surface.last() - centre)),
        std::string("The defect extends beyond the track") + (isScan ? ": increase track.length" : "") + shorter);
  // Beyond a creepage of 1 % friction is exhausted all over the patch.
  const double rolling = c.motion.speed / c.wheelset.radius;
  if (c.motion.angularVelocity > 0 && std::abs(c.motion.angularVelocity / rolling - 1) > 0.01)
    add(findings, c, Severity::warning, {"motion.angular_velocity", "motion.speed", "wheelset.radius"},
        limitText("motion.angular_velocity", "0 or within 1 % of speed / radius =", rolling),
        "The wheel slides from the start; 0 gives free rolling at any speed");
  // The patch (half length 7 mm) must be off the defect when the wheel starts.
  constexpr double patch = 0.01;
  if (c.motion.runUp < patch - surface.first())
    add(findings, c, Severity::problem, {"motion.run_up", "defect.length", "defect.points", "defect.file"},
        limitText("motion.run_up", "at least", patch - surface.first()),
        "The wheel would start on the defect: increase the run-up" + shorter);
  if (c.motion.beyond < surface.last())
    add(findings, c, Severity::warning, {"motion.beyond", "defect.length", "defect.points", "defect.file"},
        limitText("motion.beyond", "at least", surface.last()),
        "The run and the fine mesh end before the end of the defect" + unit);
  if (c.track.length < 5 * c.track.sleeperSpacing)
    add(findings, c, Severity::problem, {"track.length", "track.sleeper_spacing"},
        limitText("track.length", "at least five sleeper spacings:", 5 * c.track.sleeperSpacing),
        "Increase track.length");
  if (c.pad.longitudinalStiffness == 0 && c.track.railEnds != RailEnds::clamped)
    add(findings, c, Severity::problem, {"pad.longitudinal_stiffness", "track.rail_ends"},
        "above 0 unless track.rail_ends is clamped",
        "Nothing would hold the rail along the track: give the pads some stiffness or clamp the ends");
  if (c.pad.length > c.sleeper.width)
    add(findings, c, Severity::problem, {"pad.length", "sleeper.width"},
        limitText("pad.length", "at most sleeper.width =", c.sleeper.width), "A pad lies on its sleeper");
  if (c.sleeper.width >= c.track.sleeperSpacing)
    add(findings, c, Severity::problem, {"sleeper.width", "track.sleeper_spacing"},
        limitText("sleeper.width", "below track.sleeper_spacing =", c.track.sleeperSpacing),
        "Sleepers must not overlap");
  const double foot = 2 * geometry::railProfile(c.rail.section).footHalf;
  if (c.pad.width > foot)
    add(findings, c, Severity::problem, {"pad.width", "rail.section"}, limitText("pad.width", "at most", foot),
        "A pad lies under the foot of the rail");
  if (c.sleeper.halfLength < c.wheelset.trackCentre + 0.5 * c.pad.width)
    add(findings, c, Severity::problem, {"sleeper.half_length", "wheelset.track_centre", "pad.width"},
        limitText("sleeper.half_length", "at least", c.wheelset.trackCentre + 0.5 * c.pad.width),
        "The sleeper must support the whole pad");
  if (c.output.filterCutoff > 0.4 * c.output.rate)
    add(findings, c, Severity::problem, {"output.filter_cutoff", "output.rate"},
        limitText("output.filter_cutoff", "at most 0.4 of output.rate:", 0.4 * c.output.rate),
        "Decrease the cut-off or increase the rate");
  checkSleeperHeight(c, findings);
  checkSupports(c, findings);
}

// Where a profile of points is steepest, and whether one point stands alone there: dropouts of a scanner do.
std::string steepestPlace(const std::vector<ProfilePoint>& points) {
  const auto slope = [&](std::size_t i) {
    return (points[i].height - points[i - 1].height) / (points[i].position - points[i - 1].position);
  };
  std::size_t steepest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (steepest == 0 || std::abs(slope(i)) > std::abs(slope(steepest))) steepest = i;
  if (steepest == 0) return {};
  const auto isAlone = [&](std::size_t i) {
    return i > 0 && i + 1 < points.size() && slope(i) * slope(i + 1) < 0 &&
           std::abs(slope(i + 1)) > 0.5 * std::abs(slope(i));
  };
  const auto at = [&](std::size_t i) { return rounded(1e3 * points[i].position) + " mm"; };
  const auto apart = scenario::pointsApart(points);
  for (const std::size_t i : {steepest, steepest - 1}) {
    if (!isAlone(i)) continue;
    if (std::count(apart.begin(), apart.end(), i) > 0 || points.size() < 7)
      return ", at " + at(i) + ", where one point stands apart from its neighbours: a measuring error? " +
             "defect.filter = \"outliers\" replaces such points";
    return ", at " + at(i) + ", where heights go up and down from point to point: noise? " +
           "defect.filter = \"median\" smooths it";
  }
  return ", between " + at(steepest - 1) + " and " + at(steepest);
}

void checkDefect(const Case& c, std::vector<Finding>& findings) {
  const auto& d = c.defect;
  const auto shape = d.shape;
  const bool sampled = shape == DefectShape::profile;
  if (sampled && d.points.size() < 2 && d.lines.empty())
    add(findings, c, Severity::problem, {"defect.points", "defect.lines", "defect.file", "defect.shape"},
        "at least two points", "Give a CSV file as defect.file, or write the points into the case");
  if (sampled) checkMeasuredProfile(c, findings);
  if (sampled && !d.lines.empty() && d.lateral != LateralShape::uniform)
    add(findings, c, Severity::problem, {"defect.lateral", "defect.lines"}, "uniform if defect.lines is given",
        "The lines already define the shape across the rail");
  if (shape == DefectShape::cut && 2 * d.ramp > d.length)
    add(findings, c, Severity::problem, {"defect.ramp", "defect.length"},
        limitText("defect.ramp", "at most half of defect.length:", 0.5 * d.length),
        "Both ramps lie within the length of the cut");
  const auto surface = surfaceOf(c);
  if (surface.first() == surface.last()) return;
  const std::string pointsKey = d.lines.empty() ? "defect.points" : "defect.lines";
  const std::string depthKey = sampled ? pointsKey : "defect.depth";
  // A face that drops more than half its length would fold the elements below it.
  constexpr double steepestPossible = 0.5, steepestSensible = 0.1;
  const std::string found = " (its maximum slope is " + rounded(surface.steepest()) +
                            (sampled ? steepestPlace(scenario::countedPoints(d.points, d)) : std::string()) + ")";
  if (surface.steepest() > steepestPossible)
    add(findings, c, Severity::problem, {depthKey, "defect.length", "defect.ramp", "defect.file"},
        "such that no slope is above 0.5",
        "The profile is too steep for the mesh" + found + ": make it longer or shallower");
  else if (surface.steepest() > steepestSensible)
    add(findings, c, Severity::warning, {depthKey, "defect.length", "defect.ramp", "defect.file"},
        "such that no slope is above 0.1", "The mesh smooths steeper profiles" + found);
  if (c.rail.plastic && surface.depth() > c.rail.plasticDepth)
    add(findings, c, Severity::problem, {depthKey, "rail.plastic_depth", "defect.file"},
        "at most rail.plastic_depth = " + rounded(c.rail.plasticDepth * 1e3) + " mm",
        "The defect, " + rounded(surface.depth() * 1e3) + " mm deep, is deeper than the elastoplastic layer");
  if (d.moveNodes && surface.depth() > 2 * c.mesh.contactSize)
    add(findings, c, Severity::problem, {depthKey, "mesh.contact_size", "defect.move_nodes", "defect.file"},
        "at most twice mesh.contact_size = " + rounded(2e3 * c.mesh.contactSize) + " mm",
        "The defect is deeper than the fine layer whose nodes are moved: set defect.move_nodes to false or make it "
        "shallower");
  // Finer points move the edges of the dip a little: what the message names leaves room for that.
  constexpr double room = 0.98;
  if (sampled && surface.profileSpacing() > surface.dipLength() / 8)
    add(findings, c, Severity::warning, {pointsKey, "defect.file"},
        "sampled with points at most " + rounded(room * surface.dipLength() * 1e3 / 8, Side::below) + " mm apart",
        "Points of the profile are " + rounded(surface.profileSpacing() * 1e3) +
            " mm apart, more than an eighth of the dip: between them its shape is interpolated (monotone cubic)");
  if (sampled && surface.depth() == 0)
    add(findings, c, Severity::warning, {pointsKey, "defect.file"}, "below the surface somewhere",
        "The profile has no point below the surface: heights are positive upwards");
  const auto endsAway = [&](const std::vector<ProfilePoint>& all) {
    const auto points = scenario::countedPoints(all, d);
    return points.size() > 1 && (points.front().height != 0 || points.back().height != 0);
  };
  const bool away = d.lines.empty() ? endsAway(d.points)
                                    : std::any_of(d.lines.begin(), d.lines.end(),
                                                  [&](const ProfileLine& line) { return endsAway(line.points); });
  if (sampled && !d.level && away)
    add(findings, c, Severity::warning, {"defect.level", pointsKey, "defect.file"}, "ends at height zero",
        "The profile does not end on the undisturbed surface; it runs out over 20 mm");
}

// Where a straight tread touches the crown: where the slopes agree. Both arcs of the crown are known to the solver;
// here the middle one, R300 to at least 10 mm in every section, must hold the touching point, and the fine band of the
// mesh the patch about it.
void checkSeat(const Case& c, std::vector<Finding>& findings) {
  constexpr double crownRadius = 0.300, crownEnd = 0.010;                          // [m]
  constexpr double patchHalfWidth = 0.00516, patchLoad = 87.8e3;                   // [m] Hertz at this load [N]
  const double tilt = std::atan(c.rail.inclination) - std::atan(c.wheelset.cone);  // [rad]
  const double touch = c.motion.lateralOffset + crownRadius * tilt;
  if (touch == 0) return;
  const std::string key = c.motion.lateralOffset != 0 ? "motion.lateral_offset" : "wheelset.cone";
  const std::string found = "The wheel touches the crown at " + rounded(touch * 1e3) + " mm";
  const auto between = [&](double maximum) {
    if (key == "motion.lateral_offset")
      return rounded(1e3 * (-maximum - crownRadius * tilt)) + " to " + rounded(1e3 * (maximum - crownRadius * tilt)) +
             " mm";
    const double inclination = std::atan(c.rail.inclination);
    return rounded(std::tan(inclination - maximum / crownRadius)) + " to " +
           rounded(std::tan(inclination + maximum / crownRadius));
  };
  const Keys keys{key, "rail.inclination", "wheelset.cone", "motion.lateral_offset"};
  if (std::abs(touch) > crownEnd) {
    add(findings, c, Severity::problem, keys, between(crownEnd), found + ", beyond the middle arc R300");
    return;
  }
  const double load = (scenario::wheelsetMass(c.wheelset) + c.suspension.sprungMass) * c.motion.gravity;
  const double half = patchHalfWidth * std::cbrt(load / patchLoad);
  Keys withBand = keys;
  withBand.push_back("mesh.band_half_width");
  if (std::abs(touch) + half > c.mesh.bandHalfWidth)
    add(findings, c, Severity::problem, withBand, between(std::max(0.0, c.mesh.bandHalfWidth - half)),
        found + " and its contact patch extends to " + rounded(1e3 * (std::abs(touch) + half)) +
            " mm, beyond the fine band: increase mesh.band_half_width = " + rounded(1e3 * c.mesh.bandHalfWidth) +
            " mm");
}

void checkMesh(const Case& c, std::vector<Finding>& findings) {
  const auto& m = c.mesh;
  if (m.rollingSize < m.contactSize)
    add(findings, c, Severity::problem, {"mesh.rolling_size", "mesh.contact_size"},
        limitText("mesh.rolling_size", "at least mesh.contact_size =", m.contactSize),
        "Elements between start and defect are not finer than at the defect");
  if (m.farSize < m.rollingSize)
    add(findings, c, Severity::problem, {"mesh.far_size", "mesh.rolling_size"},
        limitText("mesh.far_size", "at least mesh.rolling_size =", m.rollingSize),
        "Elements far from the wheel are not finer than near it");
  if (m.farSize > 0.5 * c.track.sleeperSpacing)
    add(findings, c, Severity::problem, {"mesh.far_size", "track.sleeper_spacing"},
        limitText("mesh.far_size", "at most half of track.sleeper_spacing:", 0.5 * c.track.sleeperSpacing),
        "Bending needs at least two elements between sleepers");
  if (m.sectionSize < m.contactSize)
    add(findings, c, Severity::problem, {"mesh.section_size", "mesh.contact_size"},
        limitText("mesh.section_size", "at least mesh.contact_size =", m.contactSize),
        "The section is not finer than its contact band");
  if (m.rimDepth >= c.wheelset.radius - c.wheelset.rimInnerRadius)
    add(findings, c, Severity::problem, {"mesh.rim_depth", "wheelset.radius", "wheelset.rim_inner_radius"},
        limitText("mesh.rim_depth", "below the thickness of the rim,", c.wheelset.radius - c.wheelset.rimInnerRadius),
        "The fine part of the rim ends within the rim");
  if (m.bandHalfWidth > 0.4 * c.wheelset.rimWidth)
    add(findings, c, Severity::problem, {"mesh.band_half_width", "wheelset.rim_width"},
        limitText("mesh.band_half_width", "at most 0.4 of wheelset.rim_width:", 0.4 * c.wheelset.rimWidth),
        "The contact band ends within the tread");
  const auto surface = surfaceOf(c);
  if (surface.dipLength() > 0 && m.contactSize > surface.dipLength() / 4)
    add(findings, c, Severity::warning, {"mesh.contact_size", "defect.length", "defect.points", "defect.file"},
        limitText("mesh.contact_size", "at most a quarter of the length of the dip:", surface.dipLength() / 4),
        "The mesh is too coarse to resolve the shape of the defect");
}

void checkTraction(const Case& c, std::vector<Finding>& findings) {
  const double total = scenario::wheelsetMass(c.wheelset);                   // [kg]
  const double load = (total + c.suspension.sprungMass) * c.motion.gravity;  // [N]
  const double limit = c.contact.friction;
  if (c.motion.tractionCoefficient != 0) {
    if (std::abs(c.motion.tractionCoefficient) > limit)
      add(findings, c, Severity::warning, {"motion.traction_coefficient", "contact.friction"},
          limitText("motion.traction_coefficient", "at most contact.friction =", limit),
          "The torque exceeds the adhesion limit: the wheel slips");
    return;
  }
  // Part of the torque accelerates the wheelset's own rotation: F = T/R / (1 + I/(m R^2)). I of the solid parts, and of
  // discs and box at the radii of axle and journal.
  const auto& w = c.wheelset;
  const double mass = total + c.suspension.sprungMass, radius = w.radius;
  const auto solid = scenario::wheelsetSolid(w);
  const double discs = std::max(0.0, total - w.axleBoxMass - w.material.density * solid.volume);
  const double inertia = w.material.density * solid.squaredRadii + discs * w.axleRadius * w.axleRadius +
                         w.axleBoxMass * w.journalRadius * w.journalRadius;  // [kg m2]
  const double force = std::abs(c.motion.torque) / radius / (1 + inertia / (mass * radius * radius));
  const double share = load > 0 ? force / load : 0;
  if (share > 0.95 * limit)
    add(findings, c, Severity::warning,
        {"motion.torque", "contact.friction", "suspension.sprung_mass", "wheelset.total_mass", "motion.gravity"},
        limitText("motion.torque", "at most", 0.95 * limit * load * radius * (1 + inertia / (mass * radius * radius))),
        "It demands a traction of " + rounded(share) + " of the wheel load, which " +
            (share > limit ? "exceeds the adhesion limit (friction " + rounded(limit) + "): the wheel slips"
                           : "nearly reaches the adhesion limit (friction " + rounded(limit) +
                                 "): most of the contact patch slips"));
}

}  // namespace squat::cases::relations
