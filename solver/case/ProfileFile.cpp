#include "case/ProfileFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "case/DecimalNumber.h"
#include "case/PointsText.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Lines.h"
#include "text/Text.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestProfileFile = 200'000'000;  // bytes
constexpr double highest = 0.05;                         // [m]
constexpr double farthest = 1e6;                         // [m] chainages are welcome

using text::lowerCase;
using text::shown;
using text::trimmed;

std::vector<std::string_view> fieldsOf(std::string_view line, char delimiter) {
  std::vector<std::string_view> fields;
  text::splitFields(line, delimiter, fields);
  for (auto& field : fields) field = trimmed(field);
  return fields;
}

// Power of ten of a unit of length.
std::optional<int> unitPower(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, int>, 6> units{
      {{"m", 0}, {"mm", -3}, {"um", -6}, {"\xC2\xB5m", -6}, {"\xCE\xBCm", -6}, {"\xB5m", -6}}};
  for (const auto& [name, power] : units)
    if (unit == name) return power;
  return std::nullopt;
}

struct Column {
  std::string name;
  std::optional<int> power;
};

// "position [mm]", "position (mm)", "position, mm", "position mm"
Column columnOf(std::string_view field) {
  const std::string text = lowerCase(field);
  const std::size_t open = text.find_first_of("[(");
  if (open != std::string::npos) {
    const std::size_t close = text.find_first_of("])", open);
    if (close == std::string::npos) return {text, std::nullopt};
    return {std::string(trimmed(std::string_view(text).substr(0, open))),
            unitPower(trimmed(std::string_view(text).substr(open + 1, close - open - 1)))};
  }
  const std::size_t gap = text.find_last_of(", _/");
  if (gap == std::string::npos) return {text, std::nullopt};
  return {std::string(trimmed(std::string_view(text).substr(0, gap))),
          unitPower(trimmed(std::string_view(text).substr(gap + 1)))};
}

// "y = -10 mm" at the end of a column's name [m].
std::optional<double> lateralOf(const std::string& name) {
  const std::size_t equals = name.rfind('=');
  if (equals == std::string::npos) return std::nullopt;
  const std::string_view before = trimmed(std::string_view(name).substr(0, equals));
  if (before != "y" && !before.ends_with(" y")) return std::nullopt;
  const std::string_view behind = trimmed(std::string_view(name).substr(equals + 1));
  const std::size_t end = std::min(behind.find_first_not_of("+-.,0123456789"), behind.size());
  std::string number(behind.substr(0, end));
  std::replace(number.begin(), number.end(), ',', '.');
  const auto power = unitPower(trimmed(behind.substr(end)));
  return power ? parseDecimal(number, *power) : std::nullopt;
}

bool namesHeight(const std::string& name) {
  constexpr std::array<std::string_view, 6> words{"height", "z", "level", "deviation", "elevation", "profile"};
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return name == word || (word.size() > 1 && name.find(word) != std::string::npos);
  });
}

// Depths are positive downwards, in whatever language.
bool namesDepth(const std::string& name) {
  constexpr std::array<std::string_view, 8> words{"depth", "dip",    "tiefe",      "einsenkung",
                                                  "delle", "diepte", "profondeur", "creux"};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

class ProfileParser {
 public:
  ProfileParser(std::string_view text, std::string origin)
      : textLines_(text, origin, "Export the profile as CSV"), origin_(std::move(origin)) {}

  std::vector<ProfileLine> parse() {
    readHeader();
    std::string_view line;
    while (textLines_.nextRow(line)) addRow(line);
    if (lines_.front().points.size() < 2)
      fail("fewer than two points", "Give at least two lines of position and height");
    if (areDepths_) turnDepths();
    if (falls_)  // scanned towards lower chainage
      for (auto& profile : lines_) std::reverse(profile.points.begin(), profile.points.end());
    if (lines_.size() > 1)
      if (const std::string wrong = linesMistake(lines_); !wrong.empty()) fail("unusable lines", wrong);
    return std::move(lines_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& advice = {}) const {
    throw FileError(origin_, textLines_.location(), what, advice);
  }

  void readHeader() {
    std::string_view line;
    if (!textLines_.nextRow(line)) fail("empty file", "Write a header with units and at least two points");
    for (const char candidate : {',', '\t', ';'})
      if (line.find(candidate) != std::string_view::npos) delimiter_ = candidate;
    auto fields = fieldsOf(line, delimiter_);
    std::vector<Column> columns;
    // "position, mm, height, mm": the comma stands before the units as well
    if (delimiter_ == ',' && fields.size() == 4 && unitPower(fields[1]) && unitPower(fields[3]))
      columns = {{lowerCase(fields[0]), unitPower(fields[1])}, {lowerCase(fields[2]), unitPower(fields[3])}};
    else
      for (const auto field : fields) columns.push_back(columnOf(field));
    checkColumns(fields, columns);
    const auto isVertical = [](const Column& column) { return namesHeight(column.name) || namesDepth(column.name); };
    swapped_ = columns.size() == 2 && isVertical(columns[0]) && !isVertical(columns[1]);
    if (swapped_) std::swap(columns[0], columns[1]);
    areDepths_ = columns.size() == 2 && namesDepth(columns[1].name) && !namesHeight(columns[1].name);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      powers_.push_back(*columns[i].power);
      if (i > 0) lines_.push_back({columns.size() > 2 ? *lateralOf(columns[i].name) : 0.0, {}});
    }
  }

  void checkColumns(const std::vector<std::string_view>& fields, const std::vector<Column>& columns) const {
    const std::string example = "Write a header such as: position [mm]; height [mm]";
    if (std::any_of(fields.begin(), fields.end(), [](auto field) { return parseDecimal(field).has_value(); }))
      fail("no header with units", example);
    const bool sideBySide = columns.size() > 2 && columns.size() <= maximumLines + 1 &&
                            std::all_of(columns.begin() + 1, columns.end(),
                                        [](const Column& column) { return lateralOf(column.name).has_value(); });
    if (columns.size() != 2 && !sideBySide)
      fail(std::to_string(columns.size()) + (columns.size() == 1 ? " column" : " columns") + " where two are expected",
           "Keep position and height, separated by a comma, a semicolon or a tab; the header of several height columns "
           "must give their lateral positions: y = -10 mm [mm]");
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!columns[i].power) fail("header " + shown(fields[i]) + " has no unit m, mm or um", example);
  }

  // A column that is called a depth holds one: what goes down is positive, and far beyond what goes up.
  void turnDepths() {
    double deepest = 0, rising = 0;
    for (const auto& line : lines_)
      for (const auto& point : line.points)
        deepest = std::max(deepest, point.height), rising = std::max(rising, -point.height);
    if (!(deepest >= 2 * rising))
      throw FileError(origin_, "line 1", "the header says depth, but the depths have both signs, or are negative",
                      "Make depths positive, or name the column height, positive upwards");
    for (auto& line : lines_)
      for (auto& point : line.points) point.height = point.height == 0 ? 0 : -point.height;
  }

  void addRow(std::string_view line) {
    auto& first = lines_.front().points;
    if (first.size() * lines_.size() >= maximumPoints)
      fail("more than " + std::to_string(maximumPoints) + " points", "Use a larger step");
    auto fields = fieldsOf(line, delimiter_);
    if (fields.size() != powers_.size()) failForColumns(fields.size());
    if (swapped_) std::swap(fields[0], fields[1]);
    const double position = metresIn(fields[0], powers_[0]);
    if (std::abs(position) > farthest) fail("position " + shown(fields[0]) + " is beyond 1000 km", "Check the unit");
    if (!first.empty() && position == first.back().position)
      fail("position " + shown(fields[0]) + " appears twice", "Keep one height for each position");
    if (first.size() == 1) falls_ = position < first.back().position;
    if (!first.empty() && (position < first.back().position) != falls_)
      fail("position " + shown(fields[0]) + (falls_ ? " is larger" : " is smaller") + " than the previous one",
           "Sort the lines by position");
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const double height = metresIn(fields[i], powers_[i]);
      if (std::abs(height) > highest)
        fail("height " + shown(fields[i]) + " is beyond 50 mm", "Check the unit in the header");
      lines_[i - 1].points.push_back({position, height});
    }
  }

  [[noreturn]] void failForColumns(std::size_t count) const {
    const std::string expected = powers_.size() == 2 ? "two" : std::to_string(powers_.size());
    const std::string what =
        std::to_string(count) + (count == 1 ? " column" : " columns") + " where " + expected + " are expected";
    if (count > powers_.size() && delimiter_ == ',')
      fail(what, "With a decimal comma, use a semicolon or a tab between the columns");
    fail(what, powers_.size() == 2 ? "Keep position and height"
                                   : "Give as many numbers in each line as the header has columns");
  }

  // One decimal mark for the whole file: a second one would be a thousands separator.
  double metresIn(std::string_view field, int power) {
    if (field.empty()) fail("missing number", "Give position and height on each line");
    std::string text(field.substr(0, 100));
    const std::size_t mark = text.find_first_of(".,");
    if (mark != std::string::npos) {
      if (decimalMark_ == 0) decimalMark_ = text[mark];
      if (text.find_first_of(decimalMark_ == '.' ? "," : ".") != std::string::npos)
        fail(shown(field) + ": mixed decimal points and commas", "Use one of them, without thousands separators");
      text[mark] = '.';
    }
    const auto value = parseDecimal(text, power);
    if (!value) fail(shown(field) + " is not a number", "Write plain decimal numbers");
    return *value;
  }

  text::Lines textLines_;
  std::string origin_;
  char delimiter_ = ',';
  char decimalMark_ = 0;
  bool swapped_ = false, areDepths_ = false, falls_ = false;
  std::vector<int> powers_;  // of the columns, position first
  std::vector<ProfileLine> lines_;
};

}  // namespace

std::vector<ProfileLine> parseProfileLines(std::string_view text, const std::string& origin) {
  return ProfileParser(text, origin).parse();
}

std::vector<ProfileLine> readProfileLines(const std::filesystem::path& path) {
  return parseProfileLines(readWholeFile(path.string(), largestProfileFile), path.string());
}

std::vector<ProfilePoint> parseProfile(std::string_view text, const std::string& origin) {
  auto lines = parseProfileLines(text, origin);
  if (lines.size() > 1)
    throw FileError(origin, "", std::to_string(lines.size()) + " profiles side by side where one is expected",
                    "Give it as defect.file of a case, or keep one column of heights");
  return std::move(lines.front().points);
}

std::vector<ProfilePoint> readProfileFile(const std::filesystem::path& path) {
  return parseProfile(readWholeFile(path.string(), largestProfileFile), path.string());
}

}  // namespace squat::cases
