// Relations between the keys of a tread that is not round, wheel and run.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/CaseRelations.h"
#include "case/Findings.h"
#include "case/Resolve.h"
#include "scenario/TreadDeviation.h"

namespace squat::cases::relations {

namespace {

std::vector<const std::vector<ProfilePoint>*> tablesOf(const TreadShape& shape) {
  std::vector<const std::vector<ProfilePoint>*> tables;
  for (const auto& line : shape.lines) tables.push_back(&line.points);
  if (tables.empty()) tables.push_back(&shape.points);
  return tables;
}

// Whether the table fits on the tread, and is of a tread at all; false: the rest is not to be judged.
bool checkTable(const CaseDescription& c, const std::string& table, std::vector<Finding>& findings) {
  constexpr double closes = 1e-3, largest = 0.01;  // [-] of a turn, [m]
  const double turn = 2 * std::numbers::pi * c.wheelset.radius;
  double length = 0, deviation = 0;
  for (const auto* points : tablesOf(c.tread)) {
    length = std::max(length, points->back().position - points->front().position);
    for (const auto& point : *points) deviation = std::max(deviation, std::abs(point.height));
  }
  if (length > turn * (1 + closes))
    add(findings, c, Severity::problem, {table, "wheelset.radius", "wheelset.tread_deviation"},
        "at most one turn, " + millimetres(turn),
        "The table is " + millimetres(length) +
            " long, more than the circumference of the wheel: check the unit of the arc length, or cut it to one turn");
  if (deviation > largest)
    add(findings, c, Severity::problem, {table, "wheelset.tread_deviation"}, "deviations up to " + millimetres(largest),
        "A deviation of " + millimetres(deviation) +
            " is found: give the deviation from wheelset.radius, not the radius, and check its unit");
  return length <= turn * (1 + closes) && deviation <= largest;
}

void checkSteepness(const CaseDescription& c, const TreadDeviation& tread, const std::string& table,
                    std::vector<Finding>& findings) {
  constexpr double steepestPossible = 0.5, steepestSensible = 0.2;
  const std::string found = " (its maximum slope is " + rounded(tread.steepest()) + ")";
  const Keys keys{table, "wheelset.tread_deviation"};
  if (tread.steepest() > steepestPossible)
    add(findings, c, Severity::problem, keys, "such that no slope is above 0.5",
        "The deviation of the tread is too steep for the mesh" + found + ": smooth it, or check its unit");
  else if (tread.steepest() > steepestSensible)
    add(findings, c, Severity::warning, keys, "such that no slope is above 0.2",
        "The mesh smooths steeper deviations of the tread" + found);
}

void checkResolution(const CaseDescription& c, const TreadDeviation& tread, const std::string& table,
                     std::vector<Finding>& findings) {
  const double dip = tread.dipBefore() + tread.dipBehind();
  if (tread.lowest() == tread.highest() || dip == 0) return;
  const double element = tread.isLocal() ? c.mesh.contactSize : std::max(c.mesh.rollingSize, c.mesh.contactSize);
  const std::string key = tread.isLocal() ? "mesh.contact_size" : "mesh.rolling_size";
  if (element > dip / 4)
    add(findings, c, Severity::warning, {key, table, "wheelset.tread_deviation"},
        limitText(key, "at most a quarter of the dip in the tread:", dip / 4),
        "The meshes of rail and rim are too coarse to resolve the deviation of the tread");
  if (tread.spacing() > dip / 8)
    add(findings, c, Severity::warning, {table, "wheelset.tread_deviation"},
        "sampled with points at most " + millimetres(dip / 8) + " apart",
        "Points of the table are " + millimetres(tread.spacing()) +
            " apart, more than an eighth of the dip: between them its shape is interpolated (monotone cubic)");
}

// Where the tread deviates and when in the run.
void checkPlace(const CaseDescription& c, const TreadDeviation& tread, std::vector<Finding>& findings) {
  if (!tread.isLocal()) return;
  const Keys keys{"wheelset.tread_position", "motion.run_up", "motion.beyond"};
  const double from = -c.motion.runUp, to = c.motion.beyond;
  if (tread.position() > to || tread.position() + tread.dipBehind() < from) {
    const double turn = 2 * std::numbers::pi * c.wheelset.radius;
    const double met = tread.position() + turn * std::ceil((from - tread.position()) / turn);
    add(findings, c, Severity::warning, keys, rounded(from) + " to " + rounded(to) + " m, where the wheel rolls",
        met > to ? "The deepest point of the tread's deviation does not meet the rail in this run"
                 : "The flat meets the rail at " + rounded(met) +
                       " m, another turn of the wheel, where the mesh is coarse: give this position");
    return;
  }
  constexpr double patch = 0.01;  // [m]
  const double earliest = from + tread.dipBefore() + patch;
  if (tread.position() < earliest)
    add(findings, c, Severity::warning, keys, limitText("wheelset.tread_position", "at least", earliest),
        "The wheel stands on the flat when it starts, and falls or rises off it at once");
}

}  // namespace

void checkTread(const CaseDescription& c, std::vector<Finding>& findings) {
  if (c.tread.isRound()) return;
  const std::string table = c.tread.lines.empty() ? "wheelset.tread_points" : "wheelset.tread_lines";
  for (const auto* points : tablesOf(c.tread))
    if (points->size() < 2) return;  // reported with the value
  if (!checkTable(c, table, findings)) return;
  const auto tread = treadOf(c);
  checkSteepness(c, tread, table, findings);
  checkResolution(c, tread, table, findings);
  checkPlace(c, tread, findings);
  // Closed over a gap of up to 40 mm; a longer one is round.
  constexpr double closedBelow = 0.04;  // [m]
  const double turn = 2 * std::numbers::pi * c.wheelset.radius;
  const auto endsAway = [&](const std::vector<ProfilePoint>* points) {
    const bool open = turn - (points->back().position - points->front().position) > closedBelow;
    return open && (points->front().height != 0 || points->back().height != 0);
  };
  const auto tables = tablesOf(c.tread);
  if (std::any_of(tables.begin(), tables.end(), endsAway))
    add(findings, c, Severity::warning, {table, "wheelset.tread_deviation"}, "ends at deviation zero, or a whole turn",
        "The table does not cover the whole turn and does not end at zero: it runs out over 20 mm, and the rest of the "
        "tread is round");
}

}  // namespace squat::cases::relations
