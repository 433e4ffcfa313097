// Rows of the parameter table: defect.
#include "case/ParameterRows.h"

namespace squat::cases::rows {

using Case = CaseDescription;

namespace {

constexpr const char* wave = "paper, section 4.1: wave of 27 mm behind the class C squat";
constexpr const char* assumed = "assumed";

Parameter analytic(Parameter row) {
  return appliesIf("defect.shape", {"cut", "cosine", "w-shape", "dip-with-wave"}, std::move(row));
}
Parameter dipWithWave(Parameter row) { return appliesIf("defect.shape", {"dip-with-wave"}, std::move(row)); }
Parameter profile(Parameter row) { return appliesIf("defect.shape", {"profile"}, std::move(row)); }
Parameter anyDefect(Parameter row) { return appliesUnless("defect.shape", {"none"}, std::move(row)); }

// A defect that is the same all across the rail has no centre.
Parameter variesAcross(Parameter row) {
  using Relation = Requirement::Relation;
  const Requirement defect{"defect.shape", Relation::isNot, {"none"}};
  row.condition = {{defect, {"defect.lateral", Relation::isOneOf, {"parabolic"}}},
                   {defect, {"defect.lines", Relation::isNot, {"[]"}}}};
  return row;
}

void addShape(Rows& rows) {
  rows.push_back(choice(
      "defect.shape", {"none", "cut", "cosine", "w-shape", "dip-with-wave", "profile"}, DefectShape::cosine,
      +[](Case& c) -> DefectShape& { return c.defect.shape; },
      "shape along the rail: smooth rail, analytic shape or sampled profile",
      "assumed: the paper's profiles are not published as numbers"));
  rows.push_back(analytic(number(
      "defect.length", millimetre, 50, {2, 1000}, [](Case& c) -> double& { return c.defect.length; },
      "length of the dip along the rail", "paper, section 3: light defect of about 50 mm in the measured profile")));
  rows.push_back(analytic(number(
      "defect.depth", millimetre, 0.15, {0, 5}, [](Case& c) -> double& { return c.defect.depth; },
      "depth of the dip, positive", "assumed: the paper gives lengths, not depths")));
  rows.push_back(
      appliesIf("defect.shape", {"cut"},
                number(
                    "defect.ramp", millimetre, 2, {0.1, 500}, [](Case& c) -> double& { return c.defect.ramp; },
                    "length of each ramp of the cut, within its length", assumed)));
  rows.push_back(dipWithWave(
      appliesUnless("defect.wave_count", {"0"},
                    number(
                        "defect.wave_length", millimetre, 27, {2, 500},
                        [](Case& c) -> double& { return c.defect.waveLength; }, "length of one trailing wave", wave))));
  rows.push_back(dipWithWave(appliesUnless(
      "defect.wave_count", {"0"},
      number(
          "defect.wave_depth", millimetre, 0.05, {0, 5}, [](Case& c) -> double& { return c.defect.waveDepth; },
          "depth of the trailing waves", assumed))));
  rows.push_back(dipWithWave(wholeNumber(
      "defect.wave_count", 1, {0, 20}, [](Case& c) -> double& { return c.defect.waveCount; },
      "number of trailing waves", wave)));
  rows.push_back(
      appliesIf("defect.shape", {"w-shape"},
                number(
                    "defect.middle_height", none, 0.3, {0, 1}, [](Case& c) -> double& { return c.defect.middleHeight; },
                    "height of the middle ridge as a fraction of the depth", assumed)));
}

void addAcross(Rows& rows) {
  rows.push_back(anyDefect(choice(
      "defect.lateral", {"uniform", "parabolic"}, LateralShape::uniform,
      +[](Case& c) -> LateralShape& { return c.defect.lateral; }, "shape across the rail",
      "paper, sections 3 and 4.1: uniform")));
  rows.push_back(
      appliesIf("defect.lateral", {"parabolic"},
                number(
                    "defect.half_width", millimetre, 20, {2, 36}, [](Case& c) -> double& { return c.defect.halfWidth; },
                    "lateral distance from the centre at which the defect ends", assumed)));
  rows.push_back(variesAcross(number(
      "defect.lateral_centre", millimetre, 0, {-35, 35}, [](Case& c) -> double& { return c.defect.lateralCentre; },
      "lateral position of the defect's centre on the crown, outwards positive",
      "assumed: the middle; paper, section 4.2: the class C squat lay on the side of the rail, by an amount not "
      "given")));
}

void addProfile(Rows& rows) {
  rows.push_back(profile(text(
      "defect.file", [](Case& c) -> std::string& { return c.defect.file; },
      "CSV file of the profile: position and height, or heights at several lateral positions; relative to the case "
      "file; not read if the case contains defect.points or defect.lines",
      assumed)));
  rows.push_back(profile(number(
      "defect.from", metre, 0, {-1e6, 1e6}, [](Case& c) -> double& { return c.defect.from; },
      "start of the stretch of the profile that counts, in its own positions; equal to defect.to: all of it",
      "0 and 0: all that was measured")));
  rows.push_back(profile(number(
      "defect.to", metre, 0, {-1e6, 1e6}, [](Case& c) -> double& { return c.defect.to; },
      "end of the stretch of the profile that counts", "0 and 0: all that was measured")));
  rows.push_back(profile(choice(
      "defect.filter", {"none", "outliers", "median"}, ProfileFilter::none,
      +[](Case& c) -> ProfileFilter& { return c.defect.filter; },
      "filter of the measured heights: outliers replaces points that stand apart, median smooths noise as well; with "
      "either, rows of the file without a number are left out",
      "none: as measured")));
  rows.push_back(profile(appliesUnless(
      "defect.filter", {"none"},
      number(
          "defect.filter_width", millimetre, 5, {0.01, 50}, [](Case& c) -> double& { return c.defect.filterWidth; },
          "length of the window of the filter", "assumed: a tenth of a light defect"))));
  rows.push_back(profile(boolean(
      "defect.level", true, [](Case& c) -> bool& { return c.defect.level; },
      "take the line through the first and last point as the undisturbed surface", assumed)));
  rows.push_back(profile(number(
      "defect.height_scale", none, 1, {0, 10}, [](Case& c) -> double& { return c.defect.heightScale; },
      "factor on all heights of the profile", "1: as measured")));
  rows.push_back(
      profile(appliesIf("defect.lines", {"[]"},
                        points(
                            "defect.points", [](Case& c) -> std::vector<ProfilePoint>& { return c.defect.points; },
                            "pairs of position and height, negative below the surface", assumed))));
  rows.push_back(profile(lines(
      "defect.lines", [](Case& c) -> std::vector<ProfileLine>& { return c.defect.lines; },
      "several profiles side by side, each with its lateral position and its points", assumed)));
  rows.push_back(anyDefect(boolean(
      "defect.move_nodes", false, [](Case& c) -> bool& { return c.defect.moveNodes; },
      "true: move the surface nodes of the rail; false: put the profile into the gap function of the contact",
      "assumed: same result at these depths, less work; the paper moves the nodes")));
}

}  // namespace

Rows defectRows() {
  Rows rows;
  addShape(rows);
  addAcross(rows);
  addProfile(rows);
  return rows;
}

}  // namespace squat::cases::rows
