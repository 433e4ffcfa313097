#include "case/ProfileFile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/PointsText.h"
#include "case/ProfileStretch.h"
#include "case/ProfileTable.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestProfileFile = 200'000'000;  // bytes

std::vector<double> positionsOf(const ProfileTable& table) {
  constexpr double farthest = 1e6;  // [m] chainages are welcome
  std::vector<double> at;
  for (std::size_t row = 0; row < table.lines.size(); ++row) {
    at.push_back(table.position.metres(row));
    const auto wrong = [&](const std::string& what, const char* advice) {
      table.fail(table.lines[row], "position " + table.position.written(row) + what, advice);
    };
    if (std::abs(at[row]) > farthest) wrong(" is beyond 1000 km", "Check the unit");
    if (row == 0) continue;
    const bool falls = at[1] < at[0];
    if (at[row] == at[row - 1]) wrong(" appears twice", "Keep one height for each position");
    if ((at[row] < at[row - 1]) != falls)
      wrong(falls ? " is larger than the previous one" : " is smaller than the previous one",
            "Sort the lines by position");
  }
  return at;
}

std::vector<ProfilePoint> heightsOf(const ProfileTable& table, const std::vector<double>& at,
                                    const LengthColumn& column) {
  constexpr double highest = 0.05;  // [m]
  std::vector<ProfilePoint> points;
  for (std::size_t row = 0; row < at.size(); ++row) {
    points.push_back({at[row], column.metres(row)});
    if (std::abs(points.back().height) > highest)
      table.fail(table.lines[row], "height " + column.written(row) + " is beyond 50 mm",
                 "Check the unit in the header");
  }
  return points;
}

// A column that is called a depth holds one: what goes down is positive, and far beyond what goes up.
void turnDepths(const ProfileTable& table, std::vector<ProfilePoint>& points) {
  double deepest = 0, rising = 0;
  for (const auto& point : points) deepest = std::max(deepest, point.height), rising = std::max(rising, -point.height);
  if (!(deepest >= 2 * rising))
    table.fail(table.headLine, "the header says depth, but the depths have both signs, or are negative",
               "Make depths positive, or name the column height, positive upwards");
  for (auto& point : points) point.height = point.height == 0 ? 0 : -point.height;
}

// A scan of a defect with more points than a case may have keeps the stretch that is asked for.
void cut(const ProfileTable& table, std::vector<ProfileLine>& lines, const std::optional<Defect>& asked) {
  const auto tooMany = [&] { return lines.size() * lines.front().points.size() > maximumPoints; };
  if (!tooMany()) return;
  const auto whole = lines.front().points;
  const auto outside = [&](const ProfilePoint& point) {
    return point.position < asked->from || point.position > asked->to;
  };
  if (asked && asked->from < asked->to)
    for (auto& line : lines) std::erase_if(line.points, outside);
  if (tooMany())
    table.fail(0,
               std::to_string(table.lines.size()) + " rows, and a profile has at most " +
                   std::to_string(maximumPoints) + " points",
               asked ? stretchAdvice(whole) : "Keep every second line or fewer, or the stretch that is needed");
  if (lines.front().points.size() < 2)
    table.fail(0, "has fewer than two points between defect.from and defect.to",
               "Its positions are " + text::numberText(whole.front().position) + " to " +
                   text::numberText(whole.back().position) + " m");
}

// What must hold of the numbers of a profile, whatever table they stood in.
std::vector<ProfileLine> linesOf(const ProfileTable& table, const std::optional<Defect>& asked) {
  const auto at = positionsOf(table);
  std::vector<ProfileLine> all;
  for (std::size_t i = 0; i < table.heights.size(); ++i) {
    auto& points = all.emplace_back(ProfileLine{table.laterals[i], heightsOf(table, at, table.heights[i])}).points;
    if (at[1] < at[0]) std::reverse(points.begin(), points.end());  // scanned towards lower chainage
  }
  if (table.areDepths) turnDepths(table, all.front().points);
  cut(table, all, asked);
  if (all.size() > 1)
    if (const std::string wrong = linesMistake(all); !wrong.empty()) table.fail(0, "unusable lines", wrong);
  return all;
}

}  // namespace

std::vector<ProfileLine> parseProfileLines(std::string_view text, const std::string& origin,
                                           const std::optional<Defect>& asked) {
  return linesOf(profileTable(text, origin, asked), asked);
}

std::vector<ProfileLine> readProfileLines(const std::filesystem::path& path, const std::optional<Defect>& asked) {
  return parseProfileLines(readWholeFile(path.string(), largestProfileFile), path.string(), asked);
}

std::vector<ProfilePoint> parseProfile(std::string_view text, const std::string& origin,
                                       const std::optional<Defect>& asked) {
  auto lines = parseProfileLines(text, origin, asked);
  if (lines.size() > 1)
    throw FileError(origin, "", std::to_string(lines.size()) + " profiles side by side where one is expected",
                    "Keep one column of heights");
  return std::move(lines.front().points);
}

std::vector<ProfilePoint> readProfileFile(const std::filesystem::path& path) {
  return parseProfile(readWholeFile(path.string(), largestProfileFile), path.string());
}

}  // namespace squat::cases
