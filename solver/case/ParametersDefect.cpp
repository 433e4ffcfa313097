// Rows of the parameter table: defect.
#include "case/ParameterRows.h"

namespace squat::cases::rows {

using Case = CaseDescription;

namespace {
constexpr const char* wave = "paper, section 4.1: wave of 27 mm behind the class C squat";
constexpr const char* shape = "assumed";
}  // namespace

Rows defectRows() {
  Rows rows;
  rows.push_back(choice(
      "defect.shape", {"none", "cut", "cosine", "w-shape", "dip-with-wave", "profile"}, 2,
      [](Case& c) -> int& { return c.defect.shape; },
      "smooth rail, analytic shape, or sampled profile (defect.file or defect.points)",
      "assumed: the figures with the paper's profiles are not public"));
  rows.push_back(number(
      "defect.length", millimetre, 50, {2, 1000}, [](Case& c) -> double& { return c.defect.length; },
      "length of the dip along the rail (analytic shapes)",
      "paper, section 3: light defect of about 50 mm in the measured profile"));
  rows.push_back(number(
      "defect.depth", millimetre, 0.15, {0, 5}, [](Case& c) -> double& { return c.defect.depth; },
      "depth of the dip, positive (analytic shapes)", "assumed: the paper gives lengths, not depths"));
  rows.push_back(number(
      "defect.ramp", millimetre, 2, {0.1, 500}, [](Case& c) -> double& { return c.defect.ramp; },
      "length of each ramp of a cut, within its length", shape));
  rows.push_back(number(
      "defect.wave_length", millimetre, 27, {2, 500}, [](Case& c) -> double& { return c.defect.waveLength; },
      "length of a wave that follows the dip", wave));
  rows.push_back(number(
      "defect.wave_depth", millimetre, 0.05, {0, 5}, [](Case& c) -> double& { return c.defect.waveDepth; },
      "depth of the waves that follow the dip", shape));
  rows.push_back(wholeNumber(
      "defect.wave_count", 1, {0, 20}, [](Case& c) -> double& { return c.defect.waveCount; },
      "number of waves that follow the dip", wave));
  rows.push_back(number(
      "defect.middle_height", none, 0.3, {0, 1}, [](Case& c) -> double& { return c.defect.middleHeight; },
      "w-shape: height of the middle ridge as a share of the depth", shape));
  rows.push_back(choice(
      "defect.lateral", {"uniform", "parabolic"}, 0, [](Case& c) -> int& { return c.defect.lateral; },
      "shape across the rail", "paper, sections 3 and 4.1: uniform"));
  rows.push_back(number(
      "defect.half_width", millimetre, 20, {2, 36}, [](Case& c) -> double& { return c.defect.halfWidth; },
      "parabolic: lateral distance at which the defect has faded out", shape));
  rows.push_back(number(
      "defect.lateral_centre", millimetre, 0, {-35, 35}, [](Case& c) -> double& { return c.defect.lateralCentre; },
      "sideways shift of the defect on the crown, outwards positive: a squat beside the middle of the rail",
      "paper, section 4.2: the class C squat lay on the side of the rail; by how much is not given"));
  rows.push_back(text(
      "defect.file", [](Case& c) -> std::string& { return c.defect.file; },
      "CSV file with position and height of the profile, or heights at several lateral positions, relative to the case "
      "file; only named, not read, where defect.points or defect.lines stand in the case",
      shape));
  rows.push_back(boolean(
      "defect.level", true, [](Case& c) -> bool& { return c.defect.level; },
      "profile: take the line through its first and last point as the undisturbed surface", shape));
  rows.push_back(number(
      "defect.height_scale", none, 1, {0, 10}, [](Case& c) -> double& { return c.defect.heightScale; },
      "profile: factor on all heights, for studies of the depth", "1: as measured"));
  rows.push_back(points(
      "defect.points", [](Case& c) -> std::vector<ProfilePoint>& { return c.defect.points; },
      "profile: pairs of position and height, heights below the surface negative", shape));
  rows.push_back(lines(
      "defect.lines", [](Case& c) -> std::vector<ProfileLine>& { return c.defect.lines; },
      "profile: several profiles side by side, each its lateral position and its points; before defect.points", shape));
  rows.push_back(boolean(
      "defect.move_nodes", false, [](Case& c) -> bool& { return c.defect.moveNodes; },
      "move the surface nodes of the rail as the paper does, or put the profile into the gap of the contact",
      "assumed: the same at these depths, and cheaper"));
  return rows;
}

}  // namespace squat::cases::rows
