// What must hold of measured profiles: the stretch that counts, points that stand apart, and what a filter does.
#include <algorithm>
#include <cmath>

#include "case/CaseRelations.h"
#include "case/DecimalNumber.h"
#include "case/Findings.h"
#include "case/Resolve.h"
#include "scenario/MeasuredProfile.h"

namespace squat::cases::relations {

namespace {

void checkStretch(const CaseDescription& c, const std::vector<ProfilePoint>& points, std::vector<Finding>& findings) {
  const auto& d = c.defect;
  if (d.from > d.to)
    add(findings, c, Severity::problem, {"defect.to", "defect.from"}, limitText("defect.to", "at least", d.from),
        "The stretch of the profile ends before it begins; the same number twice is all of it");
  else if (points.size() > 1 && scenario::countedPoints(points, d).size() < 2)
    add(findings, c, Severity::problem, {"defect.from", "defect.to", "defect.file"},
        formatDecimal(points.front().position) + " to " + formatDecimal(points.back().position) + " m",
        "The profile has fewer than two points between defect.from and defect.to: positions are those of the file");
}

void checkApart(const CaseDescription& c, const std::vector<ProfilePoint>& points, std::vector<Finding>& findings) {
  const auto apart = scenario::pointsApart(points);
  if (apart.empty()) return;
  const std::size_t i = apart.front();
  const double off = points[i].height - 0.5 * (points[i - 1].height + points[i + 1].height);
  const std::string others = apart.size() > 1 ? ", one of " + std::to_string(apart.size()) + " such points," : "";
  add(findings, c, Severity::warning, {"defect.filter", "defect.points", "defect.lines", "defect.file"},
      "outliers where a point is a measuring error",
      "The point at " + formatDecimal(points[i].position, -3) + " mm" + others + " stands " +
          millimetres(std::abs(off)) + (off < 0 ? " below" : " above") +
          " its neighbours: defect.filter = \"outliers\" replaces such points");
}

void checkFilter(const CaseDescription& c, const std::vector<ProfilePoint>& points, std::vector<Finding>& findings) {
  constexpr double fewestSteps = 4, sensible = 0.05, roundOff = 1e-9;  // five points; share of the depth; [m]
  const double step = scenario::typicalStep(points);
  if (c.defect.filterWidth < fewestSteps * step - roundOff) {
    add(findings, c, Severity::problem, {"defect.filter_width", "defect.filter", "defect.file"},
        limitText("defect.filter_width", "at least four steps of the profile:", fewestSteps * step),
        "Its points are " + millimetres(step) + " apart: a filter needs five of them");
    return;
  }
  auto unfiltered = c;
  unfiltered.defect.filter = ProfileFilter::none;
  const double before = surfaceOf(unfiltered).depth(), depth = surfaceOf(c).depth();
  if (std::abs(depth - before) > sensible * before)
    add(findings, c, Severity::warning, {"defect.filter_width", "defect.filter", "defect.file"},
        "such that the depth stays within 5 %",
        "The filter makes the defect " + millimetres(depth) + " deep, which is " + millimetres(before) +
            " without it: right where it takes measuring errors away, else make its window shorter");
}

}  // namespace

void checkMeasuredProfile(const CaseDescription& description, std::vector<Finding>& findings) {
  const auto& d = description.defect;
  std::vector<ProfileLine> lines = d.lines;
  if (lines.empty()) lines.push_back({0, d.points});
  for (const auto& line : lines) {
    const std::size_t found = findings.size();
    checkStretch(description, line.points, findings);
    if (findings.size() > found) return;
    if (d.filter == ProfileFilter::none)
      checkApart(description, scenario::countedPoints(line.points, d), findings);
    else if (line.points.size() > 1)
      checkFilter(description, line.points, findings);
    if (findings.size() > found) return;  // of several lines, the first tells
  }
}

}  // namespace squat::cases::relations
