#include "case/TreadFile.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>

#include "case/ProfileFile.h"
#include "core/DurableFile.h"
#include "text/Lines.h"
#include "text/Text.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestTreadFile = 200'000'000;  // bytes

struct AngleUnit {
  std::size_t at = 0, size = 0;  // where the unit stands in the text
  double radians = 0;
};

// The unit of an angle at the end of the first field of the heading; nothing where it is none.
std::optional<AngleUnit> angleUnitOf(std::string_view text, const std::string& origin) {
  text::Lines lines(text, origin, "Export the deviation as CSV");
  std::string_view heading;
  if (!lines.nextRow(heading)) return std::nullopt;
  std::string_view field = heading.substr(0, heading.find_first_of(",;\t"));
  while (!field.empty() && std::string_view("\" \r])").find(field.back()) != std::string_view::npos)
    field.remove_suffix(1);
  const std::size_t before = field.find_last_of("[( _/");
  if (before == std::string_view::npos) return std::nullopt;
  const std::string_view unit = field.substr(before + 1);
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
