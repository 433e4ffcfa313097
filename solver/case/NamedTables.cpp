#include "case/NamedTables.h"

#include <algorithm>

#include "case/DynamicPads.h"
#include "case/LevelsText.h"
#include "case/ProfileFile.h"
#include "case/TreadFile.h"

namespace squat::cases {

namespace {

// One line alone is a curve, several stand side by side.
void putLines(std::vector<ProfileLine> read, std::vector<ProfilePoint>& points, std::vector<ProfileLine>& lines) {
  points.clear(), lines.clear();
  if (read.size() == 1)
    points = std::move(read.front().points);
  else
    lines = std::move(read);
}

NamedTable profile() {
  return {"defect.file",
          {"defect.points", "defect.lines"},
          "a profile file",
          [](CaseDescription& c) -> std::string& { return c.defect.file; },
          [](const CaseDescription& c) { return c.defect.shape == DefectShape::profile && !c.defect.file.empty(); },
          [](const CaseDescription& c) { return !c.defect.points.empty() || !c.defect.lines.empty(); },
          [](CaseDescription& c) { c.defect.points.clear(), c.defect.lines.clear(); },
          [](CaseDescription& c, const std::filesystem::path& path) {
            putLines(readProfileLines(path, c.defect), c.defect.points, c.defect.lines);
          }};
}

NamedTable tread() {
  return {"wheelset.tread_deviation",
          {"wheelset.tread_points", "wheelset.tread_lines"},
          "a table of the tread's deviation",
          [](CaseDescription& c) -> std::string& { return c.tread.file; },
          [](const CaseDescription& c) { return !c.tread.file.empty(); },
          [](const CaseDescription& c) { return !c.tread.isRound(); },
          [](CaseDescription& c) { c.tread.points.clear(), c.tread.lines.clear(); },
          [](CaseDescription& c, const std::filesystem::path& path) {
            putLines(readTreadLines(path, c.wheelset.radius), c.tread.points, c.tread.lines);
          }};
}

bool hasHeights(const CaseDescription& c) { return c.rail.irregularity.kind == IrregularityKind::heights; }

NamedTable irregularity() {
  return {"rail.irregularity_file",
          {"rail.irregularity_points", "rail.irregularity_levels"},
          "a table of heights, or of wavelengths and levels",
          [](CaseDescription& c) -> std::string& { return c.rail.irregularity.file; },
          [](const CaseDescription& c) {
            return !c.rail.irregularity.file.empty() &&
                   (hasHeights(c) || c.rail.irregularity.kind == IrregularityKind::spectrum);
          },
          [](const CaseDescription& c) {
            return hasHeights(c) ? !c.rail.irregularity.points.empty() : !c.rail.irregularity.levels.empty();
          },
          [](CaseDescription& c) { c.rail.irregularity.points.clear(), c.rail.irregularity.levels.clear(); },
          [](CaseDescription& c, const std::filesystem::path& path) {
            if (hasHeights(c))
              c.rail.irregularity.points = readProfileFile(path);
            else
              c.rail.irregularity.levels = formatLevels(readLevels(path));
          }};
}

NamedTable pads() {
  return {"pad.dynamic",
          {"pad.dynamic_values"},
          "a table of the complex stiffness of a pad",
          [](CaseDescription& c) -> std::string& { return c.pad.dynamicFile; },
          [](const CaseDescription& c) { return !c.pad.dynamicFile.empty(); },
          [](const CaseDescription& c) { return !c.pad.dynamicValues.empty(); },
          [](CaseDescription& c) { c.pad.dynamicValues.clear(); },
          [](CaseDescription& c, const std::filesystem::path& path) {
            c.pad.dynamicValues = formatDynamicStiffness(readDynamicStiffness(path.string()));
          }};
}

}  // namespace

const std::vector<NamedTable>& namedTables() {
  static const std::vector<NamedTable> tables{profile(), tread(), irregularity(), pads()};
  return tables;
}

const NamedTable* namedTable(const std::string& fileKey) {
  const auto& all = namedTables();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& table) { return table.fileKey == fileKey; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace squat::cases
