#include "studio/profile/ProfileImport.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/Errors.h"
#include "text/Heading.h"
#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/TableLayout.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::studio {
namespace {

constexpr std::size_t maximumLines = 100001, previewLines = 8;

// At most one line more than allowed. Throws FileError for what is not text.
std::vector<std::string_view> linesOf(const std::string& text) {
  std::vector<std::string_view> all;
  text::Lines lines(text, "the file", "Export the profile as CSV");
  for (std::string_view line; all.size() <= maximumLines && lines.next(line);) all.push_back(line);
  return all;
}

std::vector<std::string> cellsOf(std::string_view line, char delimiter) {
  std::vector<std::string_view> fields;
  text::splitFields(line, delimiter, fields);
  std::vector<std::string> cells;
  for (const auto field : fields) cells.emplace_back(text::trimmed(field));
  return cells;
}

// Position and height as they stand there; what else the line tells (a name, a remark) does not matter.
std::optional<std::pair<double, double>> numbersOf(const std::vector<std::string>& cells, const ImportChoices& choices,
                                                   bool decimalComma) {
  const char decimal = decimalComma ? ',' : '.';
  const auto location = static_cast<std::size_t>(choices.positionColumn);
  const auto rise = static_cast<std::size_t>(choices.heightColumn);
  if (cells.size() <= std::max(location, rise)) return std::nullopt;
  const auto position = text::numberIn(cells[location], decimal), height = text::numberIn(cells[rise], decimal);
  if (!position || !height) return std::nullopt;
  return std::pair{*position, *height};
}

text::TableLayout layoutOf(std::vector<std::string_view> lines, char delimiter) {
  constexpr std::size_t looked = 200;
  if (lines.size() > looked) lines.resize(looked);
  return text::findLayout(lines, delimiter, 0);
}

void level(std::vector<cases::ProfilePoint>& points, Levelling levelling) {
  if (levelling == Levelling::none || points.size() < 2) return;
  double slope = (points.back().height - points.front().height) / (points.back().position - points.front().position);
  double start = points.front().height - slope * points.front().position;
  if (levelling == Levelling::leastSquares) {
    double x = 0, z = 0, xx = 0, xz = 0;
    const auto count = static_cast<double>(points.size());
    for (const auto& point : points) x += point.position / count, z += point.height / count;
    for (const auto& point : points) {
      xx += (point.position - x) * (point.position - x);
      xz += (point.position - x) * (point.height - z);
    }
    slope = xz / xx;
    start = z - slope * x;
  }
  for (auto& point : points) point.height -= start + slope * point.position;
}

// Straight lines between the measured points.
std::vector<cases::ProfilePoint> resampled(const std::vector<cases::ProfilePoint>& points, double step) {
  const double length = points.back().position - points.front().position;
  if (!(step > 0) || points.size() < 2 || length / step > 1e5 || length < step) return points;
  std::vector<cases::ProfilePoint> result;
  std::size_t at = 0;
  const auto count = static_cast<std::size_t>(std::floor(length / step * (1 + 1e-12)));
  for (std::size_t i = 0; i <= count; ++i) {
    const double position = points.front().position + step * static_cast<double>(i);
    while (at + 2 < points.size() && points[at + 1].position < position) ++at;
    const auto &a = points[at], &b = points[at + 1];
    const double share = std::clamp((position - a.position) / (b.position - a.position), 0.0, 1.0);
    result.push_back({position, a.height + share * (b.height - a.height)});
  }
  return result;
}

}  // namespace

ImportChoices suggestedChoices(const std::string& text) try {
  ImportChoices choices;
  const auto layout = layoutOf(linesOf(text), 0);
  choices.delimiter = layout.delimiter;
  choices.decimalComma = layout.decimal == ',';
  const auto unitOf = [&](std::size_t column, double otherwise) {
    if (column >= layout.names.size()) return otherwise;
    const auto& stated = layout.units[column];
    const auto* unit = text::findUnit(stated.empty() ? text::headingOf(layout.names[column], "m").unit : stated);
    return unit && unit->si == "m" ? unit->factor : otherwise;
  };
  choices.positionUnit = unitOf(0, 1e-3);
  choices.heightUnit = unitOf(1, 1e-3);
  return choices;
} catch (const FileError&) {  // importProfile says what is wrong
  return {};
}

namespace {

ImportedProfile importLines(const std::vector<std::string_view>& lines, const ImportChoices& choices) {
  ImportedProfile result;
  result.delimiter = choices.delimiter ? choices.delimiter : layoutOf(lines, 0).delimiter;
  const bool comma = choices.decimalComma && result.delimiter != ',';
  std::size_t line = 0;
  if (choices.skippedLines >= 0)
    line = static_cast<std::size_t>(choices.skippedLines);
  else
    while (line < lines.size() && !numbersOf(cellsOf(lines[line], result.delimiter), choices, comma)) ++line;
  result.skippedLines = static_cast<int>(std::min(line, lines.size()));
  for (std::size_t i = 0; i < std::min(lines.size(), previewLines); ++i) {
    result.head.push_back(cellsOf(lines[i], result.delimiter));
    result.columns = std::max(result.columns, static_cast<int>(result.head.back().size()));
  }
  if (lines.size() > maximumLines) result.problem = "more than 100000 lines: reduce the file first";
  for (; line < lines.size() && result.problem.empty(); ++line) {
    if (text::isComment(lines[line])) continue;
    const auto numbers = numbersOf(cellsOf(lines[line], result.delimiter), choices, comma);
    if (!numbers) {
      result.problem = "line " + std::to_string(line + 1) + ": the chosen columns do not hold two numbers";
      break;
    }
    const auto [position, height] = *numbers;
    result.points.push_back({position * choices.positionUnit * (choices.reverse ? -1 : 1),
                             height * choices.heightUnit * choices.heightScale * (choices.flip ? -1 : 1)});
  }
  auto& points = result.points;
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.position < b.position; });
  const auto twin = std::adjacent_find(points.begin(), points.end(),
                                       [](const auto& a, const auto& b) { return !(a.position < b.position); });
  if (result.problem.empty() && points.size() < 3)
    result.problem = "fewer than three points: check delimiter and columns";
  else if (result.problem.empty() && twin != points.end())
    result.problem =
        "two heights at the same position, " + std::to_string(twin->position * 1e3) + " mm: check the column";
  if (!result.problem.empty()) return result;
  level(points, choices.levelling);
  points = resampled(points, choices.resampleStep);
  for (const auto& point : points)
    if (std::abs(point.height) > 0.05) result.problem = "heights above 50 mm: check the unit";
  return result;
}

}  // namespace

ImportedProfile importProfile(const std::string& text, const ImportChoices& choices) {
  try {
    return importLines(linesOf(text), choices);
  } catch (const FileError& error) {
    ImportedProfile nothing;
    nothing.problem = error.what();
    return nothing;
  }
}

}  // namespace squat::studio
