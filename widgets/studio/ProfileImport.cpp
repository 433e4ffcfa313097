#include "studio/ProfileImport.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace squat::studio {
namespace {

constexpr std::size_t mostLines = 100001, previewLines = 8;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t at = text.rfind("\xef\xbb\xbf", 0) == 0 ? 3 : 0;
  while (at < text.size() && lines.size() < mostLines + 1) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos) end = text.size();
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(std::move(line));
    at = end + 1;
  }
  return lines;
}

std::vector<std::string> cellsOf(const std::string& line, char delimiter) {
  std::vector<std::string> cells;
  std::string cell;
  const auto finish = [&] {
    const auto first = cell.find_first_not_of(" \""), last = cell.find_last_not_of(" \"");
    cells.push_back(first == std::string::npos ? std::string() : cell.substr(first, last - first + 1));
    cell.clear();
  };
  for (char letter : line) {
    if (letter != delimiter)
      cell += letter;
    else if (delimiter != ' ' || !cell.empty())
      finish();
  }
  if (!cell.empty() || delimiter != ' ') finish();
  return cells;
}

std::optional<double> numberOf(std::string cell, bool decimalComma) {
  if (decimalComma) std::replace(cell.begin(), cell.end(), ',', '.');
  if (!cell.empty() && cell[0] == '+') cell.erase(0, 1);
  double value = 0;
  const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (failure != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Position and height as they stand there; what else the line tells (a name, a remark) does not matter.
std::optional<std::pair<double, double>> numbersOf(const std::vector<std::string>& cells, const ImportChoices& choices,
                                                   bool decimalComma) {
  const auto place = static_cast<std::size_t>(choices.positionColumn);
  const auto rise = static_cast<std::size_t>(choices.heightColumn);
  if (cells.size() <= std::max(place, rise)) return std::nullopt;
  const auto position = numberOf(cells[place], decimalComma), height = numberOf(cells[rise], decimalComma);
  if (!position || !height) return std::nullopt;
  return std::pair{*position, *height};
}

bool isDecimalComma(const std::string& cell) {
  return cell.find(',') != std::string::npos && numberOf(cell, true).has_value();
}

// The first line that is no remark; where that holds numbers already, the remark above it.
std::string headingOf(const std::vector<std::string>& lines, const ImportChoices& choices) {
  std::string above;
  for (const auto& line : lines) {
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    if (line[0] != '#')
      return numbersOf(cellsOf(line, choices.delimiter), choices, choices.decimalComma) ? above : line;
    above = line;
  }
  return above;
}

char findDelimiter(const std::vector<std::string>& lines) {
  for (char candidate : {';', '\t', ',', ' '}) {
    std::size_t found = 0;
    for (const auto& line : lines)
      found += cellsOf(line, candidate).size() >= 2 && line.find(candidate) != std::string::npos;
    if (2 * found > lines.size()) return candidate;
  }
  return ',';
}

// "height [mm]", "z (um)", "z_mm", not the letters within "Column" or "maximum".
bool hasWord(const std::string& text, const std::string& word) {
  const auto isLetter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || (c & 0x80); };
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const auto end = at + word.size();
    if ((at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]))) return true;
  }
  return false;
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

ImportChoices suggestedChoices(const std::string& text) {
  ImportChoices choices;
  const auto lines = linesOf(text);
  choices.delimiter = findDelimiter(lines);
  if (choices.delimiter != ',') {
    for (const auto& line : lines) {
      const auto cells = cellsOf(line, choices.delimiter);
      if (line[0] != '#' && std::any_of(cells.begin(), cells.end(), isDecimalComma)) choices.decimalComma = true;
    }
  }
  const auto header = cellsOf(headingOf(lines, choices), choices.delimiter);
  const auto unitOf = [](const std::string& cell, double standard) {
    for (const auto& [name, metres] : {std::pair{"um", 1e-6}, {"µm", 1e-6}, {"mm", 1e-3}, {"m", 1.0}})
      if (hasWord(cell, name)) return metres;
    return standard;
  };
  if (header.size() > 0) choices.positionUnit = unitOf(header[0], 1e-3);
  if (header.size() > 1) choices.heightUnit = unitOf(header[1], 1e-3);
  return choices;
}

ImportedProfile importProfile(const std::string& text, const ImportChoices& choices) {
  ImportedProfile result;
  const auto lines = linesOf(text);
  result.delimiter = choices.delimiter ? choices.delimiter : findDelimiter(lines);
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
  if (lines.size() > mostLines) result.problem = "more than 100000 lines: reduce the file first";
  for (; line < lines.size() && result.problem.empty(); ++line) {
    if (lines[line].find_first_not_of(" \t") == std::string::npos || lines[line][0] == '#') continue;
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

}  // namespace squat::studio
