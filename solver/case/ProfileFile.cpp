#include "case/ProfileFile.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <optional>
#include <utility>

#include "case/DecimalNumber.h"
#include "case/PointsText.h"
#include "case/ProfileStretch.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/DelimitedTable.h"
#include "text/Heading.h"
#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestProfileFile = 200'000'000;  // bytes
constexpr double highest = 0.05;                         // [m]
constexpr double farthest = 1e6;                         // [m] chainages are welcome
constexpr const char* exampleHeader = "Write a header such as: position [mm]; height [mm]";
constexpr const char* exportAdvice = "Export the profile as CSV";
constexpr const char* leaveOutAdvice =
    "Give position and height on each line, or set defect.filter, which leaves such lines out";
constexpr const char* twoPoints = "Give at least two lines of position and height";

using text::Heading;
using text::shown;

// [m] exact to the last digit: where the unit is a power of ten, decimal digits are shifted (DecimalNumber.h).
double metresIn(double value, double factor) {
  const int power = static_cast<int>(std::lround(std::log10(factor)));
  const auto exact = parseDecimal("1", power) == factor ? parseDecimal(text::numberText(value), power) : std::nullopt;
  return exact.value_or(value * factor);
}

std::optional<double> lengthFactor(const std::string& unit) {
  const auto* known = text::findUnit(text::bareUnit(unit));
  return known && known->si == "m" ? std::optional(known->factor) : std::nullopt;
}

// "y = -10 mm" at the end of a column's name [m].
std::optional<double> lateralOf(const std::string& name) {
  const std::size_t equals = name.rfind('=');
  if (equals == std::string::npos) return std::nullopt;
  const std::string_view before = text::trimmed(std::string_view(name).substr(0, equals));
  if (before != "y" && !before.ends_with(" y")) return std::nullopt;
  const std::string_view behind = text::trimmed(std::string_view(name).substr(equals + 1));
  const std::size_t end = std::min(behind.find_first_not_of("+-.,0123456789"), behind.size());
  const auto number = text::numberIn(behind.substr(0, end), behind.find(',') < end ? ',' : '.');
  const auto factor = lengthFactor(std::string(text::trimmed(behind.substr(end))));
  return number && factor ? std::optional(metresIn(*number, *factor)) : std::nullopt;
}

std::string columnsWhere(std::size_t count, std::size_t expected) {
  return std::to_string(count) + (count == 1 ? " column" : " columns") + " where " +
         (expected == 2 ? "two" : std::to_string(expected)) + " are expected";
}

bool hasOneOf(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](auto word) { return name.find(word) != std::string::npos; });
}

// In English, German, Dutch and French. "profile depth" is a depth, "height of the profile" a height.
bool namesHeight(const std::string& name) {
  return name == "z" ||
         hasOneOf(name, {"height", "elevation", "deviation", "altitude", "h\xC3\xB6he", "hoehe", "hoogte", "hauteur"});
}

// Depths are positive downwards.
bool namesDepth(const std::string& name) {
  return !namesHeight(name) &&
         hasOneOf(name, {"depth", "dip", "tiefe", "einsenkung", "delle", "diepte", "profondeur", "creux"});
}

bool isVertical(const std::string& name) {
  return namesHeight(name) || namesDepth(name) || hasOneOf(name, {"level", "profil", "niveau"});
}

// One file on its way from a table to profiles.
class ProfileReader {
 public:
  ProfileReader(std::string_view text, std::string origin, const Defect& asked)
      : text_(text), origin_(std::move(origin)), asked_(asked) {}

  std::vector<ProfileLine> read() {
    text::Lines lines(text_, origin_, exportAdvice);
    std::string_view line;
    if (!lines.nextRow(line)) fail(0, "empty file", "Write a header with units and at least two points");
    if (!lines.nextRow(line)) fail(0, "fewer than two points", twoPoints);
    layout_ = text::layoutOf(text_, origin_, 0, 0);
    if (layout_.names.empty()) failForHeading();
    table_ = text::parseDelimitedTable(text_, origin_);
    findRoles();
    requireLengths(position_);
    for (const std::size_t column : heights_) requireLengths(column);
    findRows();
    if (rows_.size() < 2) fail(table_.lines.front(), "fewer than two points", twoPoints);
    return profiles();
  }

 private:
  // `line` from 1; 0: of the whole file.
  [[noreturn]] void fail(std::size_t line, const std::string& what, const std::string& advice) const {
    throw FileError(origin_, line > 0 ? "line " + std::to_string(line) : std::string(), what, advice);
  }

  // The rows have no heading, or one of another number of columns.
  [[noreturn]] void failForHeading() const {
    text::Lines lines(text_, origin_, exportAdvice);
    std::string_view line;
    std::vector<std::string_view> fields;
    while (lines.nextRow(line) && lines.number() <= layout_.firstLine) {
      text::splitRow(line, layout_, fields);
      if (fields.size() < 2 || !lengthFactor(text::bracketedHeading(fields[0]).unit)) continue;
      fail(layout_.firstLine + 1, columnsWhere(layout_.fields, fields.size()),
           layout_.fields > fields.size() && layout_.delimiter == ','
               ? "With a decimal comma, use a semicolon or a tab between the columns"
               : "Give as many numbers in each line as the header has columns");
    }
    fail(layout_.firstLine + 1, "no header with units", exampleHeader);
  }

  void findRoles() {
    std::vector<std::size_t> positions;
    for (const auto& column : table_.columns) {
      auto heading = column.unit.empty() ? text::headingOf(column.name, "m") : Heading{column.name, column.unit};
      if (column.kilometresAndMetres) heading.unit = "km+m";
      heading.name = text::lowerCase(heading.name);
      const std::size_t i = columns_.size();
      if (isVertical(heading.name)) heights_.push_back(i);
      if (!isVertical(heading.name) && text::siUnitOfName(heading.name) == "m") positions.push_back(i);
      if (const auto lateral = lateralOf(heading.name); lateral && i > 0) laterals_.push_back(*lateral);
      columns_.push_back(std::move(heading));
    }
    const std::size_t count = columns_.size();
    if (count > 2 && count <= maximumLines + 1 && laterals_.size() == count - 1) {  // side by side
      heights_.resize(count - 1);
      std::iota(heights_.begin(), heights_.end(), 1);
      return;
    }
    if (count == 2) {
      position_ = heights_.size() == 1 && heights_[0] == 0 ? 1 : 0;
      heights_ = {1 - position_};
    } else if (laterals_.empty() && positions.size() == 1 && heights_.size() == 1) {
      position_ = positions[0];
    } else {
      fail(layout_.headLine, columnsWhere(count, 2),
           "Keep position and height, separated by a comma, a semicolon or a tab; the header of several height columns "
           "must give their lateral positions: y = -10 mm [mm]");
    }
    laterals_ = {0};
  }

  void requireLengths(std::size_t c) const {
    const auto& column = table_.columns[c];
    const std::string &unit = columns_[c].unit, header = "header " + shown(column.name);
    if (column.moments) fail(layout_.headLine, header + " stands over dates or times", "Give lengths");
    if (!lengthFactor(unit))
      fail(layout_.headLine,
           header + (unit.empty() ? " has no unit of length" : " is in " + unit + ", which is no known unit of length"),
           exampleHeader);
    if (column.badRow >= table_.rows()) return;
    const std::size_t line = table_.lines[column.badRow];
    const std::string& bad = column.badText;
    // One decimal mark for the whole file: a second one would be a thousands separator.
    const bool mixed =
        bad.find_first_not_of("'+-.,0123456789eE") == std::string::npos && bad.find_first_of(".,") != std::string::npos;
    if (mixed) fail(line, bad + ": mixed decimal points and commas", "Use one of them, without thousands separators");
    const bool missing = bad.front() != '\'' || text::isMissing(std::string_view(bad).substr(1, bad.size() - 2));
    if (!missing) fail(line, bad + " is not a number", "Write plain decimal numbers");
    if (!leavesOut()) fail(line, "missing number: " + bad, leaveOutAdvice);
  }

  bool leavesOut() const { return asked_.filter != ProfileFilter::none; }

  // The value of a column that stands for none: a usual mark, where all other values are far smaller.
  double absentIn(std::size_t column) const {
    std::vector<double> sizes;
    for (const double value : table_.columns[column].values)
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
    if (sizes.empty()) return HUGE_VAL;
    std::sort(sizes.begin(), sizes.end());
    const double usual = sizes[sizes.size() / 2];
    for (const double mark : {999.0, 9999.0, 99999.0, 32768.0, 999.25}) {
      const auto from = std::lower_bound(sizes.begin(), sizes.end(), 0.5 * mark);
      if (from != sizes.end() && *from == mark && sizes.back() == mark && mark > 20 * usual) return mark;
    }
    return HUGE_VAL;
  }

  // The rows that have all their numbers.
  void findRows() {
    auto columns = heights_;
    columns.push_back(position_);
    std::vector<double> absent;
    for (const std::size_t column : columns) absent.push_back(column == position_ ? HUGE_VAL : absentIn(column));
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      bool whole = true;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const double value = table_.columns[columns[i]].values[row];
        if (std::abs(value) == absent[i] && !leavesOut())
          failAt(columns[i], row, " stands for no value, it seems", leaveOutAdvice);
        whole = whole && std::isfinite(value) && std::abs(value) != absent[i];
      }
      if (whole) rows_.push_back(row);
    }
    if (4 * rows_.size() < 3 * table_.rows())
      fail(0,
           std::to_string(table_.rows() - rows_.size()) + " of " + std::to_string(table_.rows()) +
               " rows have no number",
           "A filter bridges at most a quarter of the rows: measure again, or use another column");
  }

  double metres(std::size_t column, std::size_t row) const {
    return metresIn(table_.columns[column].values[row], *lengthFactor(columns_[column].unit));
  }

  // Fails at a row, with the number as the file has it: "position 12.5 mm appears twice".
  [[noreturn]] void failAt(std::size_t column, std::size_t row, const std::string& what,
                           const std::string& advice) const {
    const std::string& unit = columns_[column].unit;
    fail(table_.lines[row],
         (column == position_ ? "position " : "height ") + text::numberText(table_.columns[column].values[row]) + " " +
             text::printedUnit(unit == "km+m" ? "m" : unit) + what,
         advice);
  }

  std::vector<ProfileLine> profiles() const {
    std::vector<double> at;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::size_t row = rows_[i];
      at.push_back(metres(position_, row));
      if (std::abs(at[i]) > farthest) failAt(position_, row, " is beyond 1000 km", "Check the unit");
      if (i == 0) continue;
      if (at[i] == at[i - 1]) failAt(position_, row, " appears twice", "Keep one height for each position");
      if ((at[i] < at[i - 1]) != (at[1] < at[0]))
        failAt(position_, row, at[1] < at[0] ? " is larger than the previous one" : " is smaller than the previous one",
               "Sort the lines by position");
    }
    std::vector<ProfileLine> lines;
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      auto& points = lines.emplace_back(ProfileLine{laterals_[i], {}}).points;
      for (std::size_t k = 0; k < at.size(); ++k) {
        points.push_back({at[k], metres(heights_[i], rows_[k])});
        if (std::abs(points.back().height) > highest)
          failAt(heights_[i], rows_[k], " is beyond 50 mm", "Check the unit in the header");
      }
      if (at[1] < at[0]) std::reverse(points.begin(), points.end());  // scanned towards lower chainage
    }
    if (heights_.size() == 1 && namesDepth(columns_[heights_[0]].name)) turnDepths(lines.front());
    cut(lines);
    if (lines.size() > 1)
      if (const std::string wrong = linesMistake(lines); !wrong.empty()) fail(0, "unusable lines", wrong);
    return lines;
  }

  // A scan with more points than a case may have keeps the stretch that is asked for.
  void cut(std::vector<ProfileLine>& lines) const {
    const auto tooMany = [&] { return lines.size() * lines.front().points.size() > maximumPoints; };
    if (!tooMany()) return;
    const auto whole = lines.front().points;
    const double from = asked_.from, to = asked_.to;
    const auto outside = [&](const ProfilePoint& point) { return point.position < from || point.position > to; };
    if (from < to)
      for (auto& line : lines) std::erase_if(line.points, outside);
    if (tooMany())
      fail(0,
           std::to_string(rows_.size()) + " rows, and a profile has at most " + std::to_string(maximumPoints) +
               " points",
           stretchAdvice(whole));
    if (lines.front().points.size() < 2)
      fail(0, "has fewer than two points between defect.from and defect.to",
           "Its positions are " + text::numberText(whole.front().position) + " to " +
               text::numberText(whole.back().position) + " m");
  }

  // A column that is called a depth holds one: what goes down is positive, and far beyond what goes up.
  void turnDepths(ProfileLine& line) const {
    double deepest = 0, rising = 0;
    for (const auto& point : line.points)
      deepest = std::max(deepest, point.height), rising = std::max(rising, -point.height);
    if (!(deepest >= 2 * rising))
      fail(layout_.headLine, "the header says depth, but the depths have both signs, or are negative",
           "Make depths positive, or name the column height, positive upwards");
    for (auto& point : line.points) point.height = point.height == 0 ? 0 : -point.height;
  }

  std::string_view text_;
  std::string origin_;
  const Defect& asked_;
  text::TableLayout layout_;
  text::DelimitedTable table_;
  std::vector<Heading> columns_;  // names in small letters; units as the file has them
  std::size_t position_ = 0;
  std::vector<std::size_t> heights_;
  std::vector<std::size_t> rows_;  // of the table, that have all their numbers
  std::vector<double> laterals_;   // [m] of each column of heights
};

}  // namespace

std::vector<ProfileLine> parseProfileLines(std::string_view text, const std::string& origin, const Defect& asked) {
  return ProfileReader(text, origin, asked).read();
}

std::vector<ProfileLine> readProfileLines(const std::filesystem::path& path, const Defect& asked) {
  return parseProfileLines(readWholeFile(path.string(), largestProfileFile), path.string(), asked);
}

std::vector<ProfilePoint> parseProfile(std::string_view text, const std::string& origin, const Defect& asked) {
  auto lines = parseProfileLines(text, origin, asked);
  if (lines.size() > 1)
    throw FileError(origin, "", std::to_string(lines.size()) + " profiles side by side where one is expected",
                    "Give it as defect.file of a case, or keep one column of heights");
  return std::move(lines.front().points);
}

}  // namespace squat::cases
