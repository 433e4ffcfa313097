#include "case/ProfileTable.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <optional>

#include "case/DecimalNumber.h"
#include "case/PointsText.h"
#include "core/Errors.h"
#include "text/DelimitedTable.h"
#include "text/Heading.h"
#include "text/Lines.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::cases {

namespace {

constexpr const char* exampleHeader = "Write a header such as: position [mm]; height [mm]";
constexpr const char* twoPoints = "Give at least two lines of position and height";
constexpr const char* wholeLines = "Give position and height on each line";
constexpr const char* leaveOutAdvice =
    "Give position and height on each line, or set defect.filter, which leaves such lines out";

// Where the unit is a power of ten, decimal digits are shifted (DecimalNumber.h).
double metresIn(double value, double factor) {
  const int power = static_cast<int>(std::lround(std::log10(factor)));
  const auto exact = parseDecimal("1", power) == factor ? parseDecimal(text::numberText(value), power) : std::nullopt;
  return exact.value_or(value * factor);
}

std::optional<double> lengthFactor(std::string_view unit) {
  const auto* known = text::findUnit(text::bareUnit(unit));
  return known && known->si == "m" ? std::optional(known->factor) : std::nullopt;
}

// "y = -10 mm" at the end of a column's name [m].
std::optional<double> lateralOf(std::string_view name) {
  const std::size_t equals = name.rfind('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const auto before = text::trimmed(name.substr(0, equals)), behind = text::trimmed(name.substr(equals + 1));
  if (before != "y" && !before.ends_with(" y")) return std::nullopt;
  const std::size_t end = std::min(behind.find_first_not_of("+-.,0123456789"), behind.size());
  const auto number = text::numberIn(behind.substr(0, end), behind.find(',') < end ? ',' : '.');
  const auto factor = lengthFactor(behind.substr(end));
  return number && factor ? std::optional(metresIn(*number, *factor)) : std::nullopt;
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

std::string columnsWhere(std::size_t count, std::size_t expected) {
  return std::to_string(count) + (count == 1 ? " column" : " columns") + " where " +
         (expected == 2 ? "two" : std::to_string(expected)) + " are expected";
}

// One text on its way from a table to lengths.
class Reader {
 public:
  Reader(std::string_view text, const std::string& origin, const std::optional<Defect>& asked)
      : text_(text),
        leavesOut_(asked && asked->filter != ProfileFilter::none),
        wholeLines_(asked ? leaveOutAdvice : wholeLines) {
    result_.origin = origin;
  }

  ProfileTable read() {
    auto lines = textLines();
    std::string_view line;
    if (!lines.nextRow(line)) fail(0, "empty file", "Write a header with units and at least two points");
    if (!lines.nextRow(line)) fail(0, "fewer than two points", twoPoints);
    layout_ = text::layoutOf(text_, result_.origin, 0, 0);
    if (layout_.names.empty()) failForHeading();
    table_ = text::parseDelimitedTable(text_, result_.origin);
    result_.headLine = layout_.headLine;
    findRoles();
    findRows();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what, const std::string& advice) const {
    result_.fail(line, what, advice);
  }

  text::Lines textLines() const { return {text_, result_.origin, "Export the profile as CSV"}; }

  // The rows have no heading, or one of another number of columns.
  [[noreturn]] void failForHeading() const {
    auto lines = textLines();
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
    std::vector<text::Heading> headings;
    std::vector<std::size_t> positions, heights;
    for (const auto& column : table_.columns) {
      auto heading = column.unit.empty() ? text::headingOf(column.name, "m") : text::Heading{column.name, column.unit};
      heading.name = text::lowerCase(heading.name);
      const std::size_t i = headings.size();
      if (isVertical(heading.name)) heights.push_back(i);
      if (!isVertical(heading.name) && text::siUnitOfName(heading.name) == "m") positions.push_back(i);
      if (const auto lateral = lateralOf(heading.name); lateral && i > 0) result_.laterals.push_back(*lateral);
      headings.push_back(std::move(heading));
    }
    const std::size_t count = headings.size();
    if (count > 2 && count <= maximumLines + 1 && result_.laterals.size() == count - 1) {  // side by side
      positions = {0};
      heights.resize(count - 1);
      std::iota(heights.begin(), heights.end(), 1);
    } else if (count == 2) {
      positions = {heights.size() == 1 && heights[0] == 0 ? std::size_t{1} : 0};
      heights = {1 - positions[0]};
      result_.laterals = {0};
    } else if (result_.laterals.empty() && positions.size() == 1 && heights.size() == 1) {
      result_.laterals = {0};
    } else {
      fail(layout_.headLine, columnsWhere(count, 2),
           "Keep position and height, separated by a comma, a semicolon or a tab; the header of several height columns "
           "must give their lateral positions: y = -10 mm [mm]");
    }
    result_.position = lengths(positions[0], headings[positions[0]]);
    for (const std::size_t i : heights) result_.heights.push_back(lengths(i, headings[i]));
    result_.areDepths = heights.size() == 1 && namesDepth(headings[heights[0]].name);
  }

  // The column with what stands for no number as not-a-number; fails where that is more than a missing one.
  LengthColumn lengths(std::size_t c, const text::Heading& heading) const {
    const auto& column = table_.columns[c];
    const std::string unit = column.kilometresAndMetres ? "m" : heading.unit,
                      header = "header " + text::shown(column.name);
    if (column.moments) fail(layout_.headLine, header + " stands over dates or times", "Give lengths");
    const auto factor = lengthFactor(unit);
    if (!factor)
      fail(layout_.headLine,
           header + (unit.empty() ? " has no unit of length" : " is in " + unit + ", which is no known unit of length"),
           exampleHeader);
    if (column.badRow < table_.rows()) judgeBad(table_.lines[column.badRow], column.badText);
    return {heading.name, unit, *factor, column.values};
  }

  void judgeBad(std::size_t line, const std::string& bad) const {
    // One decimal mark for the whole file: a second one would be a thousands separator.
    const bool mixed =
        bad.find_first_not_of("'+-.,0123456789eE") == std::string::npos && bad.find_first_of(".,") != std::string::npos;
    if (mixed) fail(line, bad + ": mixed decimal points and commas", "Use one of them, without thousands separators");
    const bool missing = bad.front() != '\'' || text::isMissing(std::string_view(bad).substr(1, bad.size() - 2));
    if (!missing) fail(line, bad + " is not a number", "Write plain decimal numbers");
    if (!leavesOut_) fail(line, "missing number: " + bad, wholeLines_);
  }

  // A usual mark for no value, where all other values are far smaller.
  static double absentIn(const LengthColumn& column) {
    std::vector<double> sizes;
    for (const double value : column.values)
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
    std::sort(sizes.begin(), sizes.end());
    for (const double mark : {999.0, 999.25, 9999.0, 99999.0, 32768.0}) {
      const auto from = std::lower_bound(sizes.begin(), sizes.end(), 0.5 * mark);
      if (from != sizes.end() && *from == mark && sizes.back() == mark && mark > 20 * sizes[sizes.size() / 2])
        return mark;
    }
    return HUGE_VAL;
  }

  // Keeps the rows that have all their numbers.
  void findRows() {
    for (auto& column : result_.heights) {
      const double absent = absentIn(column);
      for (std::size_t row = 0; row < column.values.size(); ++row) {
        if (std::abs(column.values[row]) != absent) continue;
        if (!leavesOut_)
          fail(table_.lines[row], "height " + column.written(row) + " stands for no value, it seems", wholeLines_);
        column.values[row] = std::nan("");
      }
    }
    std::vector<LengthColumn*> columns{&result_.position};
    for (auto& column : result_.heights) columns.push_back(&column);
    std::size_t kept = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (std::any_of(columns.begin(), columns.end(), [&](auto* c) { return std::isnan(c->values[row]); })) continue;
      for (auto* column : columns) column->values[kept] = column->values[row];
      result_.lines.push_back(table_.lines[row]);
      ++kept;
    }
    for (auto* column : columns) column->values.resize(kept);
    if (4 * kept < 3 * table_.rows())
      fail(0, std::to_string(table_.rows() - kept) + " of " + std::to_string(table_.rows()) + " rows have no number",
           "A filter bridges at most a quarter of the rows: measure again, or use another column");
    if (kept < 2) fail(table_.lines.front(), "fewer than two points", twoPoints);
  }

  std::string_view text_;
  bool leavesOut_;
  const char* wholeLines_;  // what to do with a line that is not whole
  text::TableLayout layout_;
  text::DelimitedTable table_;
  ProfileTable result_;
};

}  // namespace

void ProfileTable::fail(std::size_t line, const std::string& what, const std::string& advice) const {
  throw FileError(origin, line > 0 ? "line " + std::to_string(line) : std::string(), what, advice);
}

double LengthColumn::metres(std::size_t row) const { return metresIn(values[row], factor); }

std::string LengthColumn::written(std::size_t row) const {
  return text::numberText(values[row]) + " " + text::printedUnit(unit);
}

ProfileTable profileTable(std::string_view text, const std::string& origin, const std::optional<Defect>& asked) {
  return Reader(text, origin, asked).read();
}

}  // namespace squat::cases
