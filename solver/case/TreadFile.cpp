#include "case/TreadFile.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>

#include "case/ProfileFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/DelimitedTable.h"
#include "text/Lines.h"
#include "text/Text.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestTreadFile = 200'000'000;  // bytes

struct AngleUnit {
  std::size_t at = 0, size = 0;  // where the unit stands in the text
  double radians = 0;
};

enum class Row { heading, units };

// The unit of an angle at the end of the first field of a heading, or alone in that of a row of units.
std::optional<AngleUnit> angleUnitIn(std::string_view row, Row kind, std::string_view text) {
  std::string_view field = row.substr(0, row.find_first_of(",;\t"));
  while (!field.empty() && std::string_view("\" \r])").find(field.back()) != std::string_view::npos)
    field.remove_suffix(1);
  const std::size_t from = field.find_last_of("[( _/\"") + 1;  // of what is not found: 0
  if (kind == Row::units && field.substr(0, from).find_first_not_of("[( \"") != std::string_view::npos)
    return std::nullopt;
  const std::string_view unit = field.substr(from);
  constexpr double degree = std::numbers::pi / 180;
  constexpr std::array<std::pair<std::string_view, double>, 7> angles{{{"rad", 1},
                                                                       {"radian", 1},
                                                                       {"radians", 1},
                                                                       {"deg", degree},
                                                                       {"degree", degree},
                                                                       {"degrees", degree},
                                                                       {"\xC2\xB0", degree}}};
  for (const auto& [name, radians] : angles)
    if (text::lowerCase(unit) == name)
      return AngleUnit{static_cast<std::size_t>(unit.data() - text.data()), unit.size(), radians};
  return std::nullopt;
}

// Above the heading may stand other lines, below it a row of units. Nothing where positions are no angles, or where no
// table is found: whoever reads the profile says why.
std::optional<AngleUnit> angleUnitOf(std::string_view text, const std::string& origin) {
  std::size_t heading = 0, end = 0;  // lines from 1, where the heading and the last row above the numbers stand
  try {
    const auto layout = text::layoutOf(text, origin, 0, 0);
    heading = layout.headLine, end = layout.firstLine;
  } catch (const FileError&) {
    return std::nullopt;
  }
  text::Lines lines(text, origin, "Export the deviation as CSV");
  for (std::string_view row; lines.next(row) && lines.number() <= end;) {
    if (lines.number() < heading) continue;
    const Row kind = heading == 0 || lines.number() == heading ? Row::heading : Row::units;
    if (const auto unit = angleUnitIn(row, kind, text)) return unit;
  }
  return std::nullopt;
}

}  // namespace

std::vector<ProfileLine> parseTreadLines(std::string_view text, const std::string& origin, double radius) {
  const auto angle = angleUnitOf(text, origin);
  if (!angle) return parseProfileLines(text, origin);
  // Angles are read as metres and become lengths of arc.
  std::string asMetres(text);
  asMetres.replace(angle->at, angle->size, "m");
  auto lines = parseProfileLines(asMetres, origin);
  for (auto& line : lines)
    for (auto& point : line.points) point.position *= angle->radians * radius;
  return lines;
}

std::vector<ProfileLine> readTreadLines(const std::filesystem::path& path, double radius) {
  return parseTreadLines(readWholeFile(path.string(), largestTreadFile), path.string(), radius);
}

}  // namespace squat::cases
