#include "text/TableLayout.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "text/Heading.h"
#include "text/Lines.h"
#include "text/Moments.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"
#include "text/Utf8Text.h"

namespace squat::text {
namespace {

bool isPlainNumber(std::string_view field, char decimal) {
  return numberIn(field, decimal) || kilometresAndMetresIn(field, decimal);
}

bool isNumeric(std::string_view field, char decimal) { return isPlainNumber(field, decimal) || momentIn(field); }

struct Candidate {
  char delimiter, decimal;
  std::size_t fields = 0, lines = 0;
  std::size_t numbers = 0, all = 0;  // fields
  bool closed = true;                // every line ends with a delimiter
};

// Goes back from the last line as long as the number of fields stays and at least one of them is a number.
Candidate judge(const std::vector<std::string_view>& lines, char delimiter, char decimal) {
  Candidate result{delimiter, decimal};
  std::vector<std::string_view> fields;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    if (isComment(*line)) continue;
    splitFields(*line, delimiter, fields);
    if (result.lines > 0 && fields.size() != result.fields) break;
    const auto numbers = static_cast<std::size_t>(
        std::count_if(fields.begin(), fields.end(), [&](auto field) { return isNumeric(field, decimal); }));
    if (numbers == 0) break;
    result.fields = fields.size();
    result.closed = result.closed && fields.size() > 1 && trimmed(fields.back()).empty();
    ++result.lines;
    result.numbers += numbers;
    result.all += fields.size();
  }
  return result;
}

bool better(const Candidate& a, const Candidate& b) {
  const auto key = [](const Candidate& c) {
    const double share = c.all ? static_cast<double>(c.numbers) / static_cast<double>(c.all) : 0.0;
    return std::make_tuple(c.lines, share, c.numbers);
  };
  return key(a) > key(b);
}

std::string_view withoutMarker(std::string_view line) {
  line = trimmed(line);
  while (!line.empty() && (line.front() == '#' || line.front() == '%')) line.remove_prefix(1);
  return line;
}

// A unit that the delimiter parts from its name belongs to it: one in brackets where blanks are the delimiter, "time
// [ms] aba [g]", and a known one behind each name, "time, ms, aba, g".
void joinUnits(std::vector<std::string_view>& fields, const TableLayout& layout) {
  bool pairs = fields.size() == 2 * layout.fields;
  for (std::size_t i = 1; pairs && i < fields.size(); i += 2) pairs = findUnit(bareUnit(fields[i])) != nullptr;
  if (!pairs && layout.delimiter != ' ') return;
  std::vector<std::string_view> joined;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (const auto field = fields[i];
        pairs ? i % 2 == 1 : i > 0 && !field.empty() && (field.front() == '[' || field.front() == '('))
      joined.back() = {joined.back().data(),
                       static_cast<std::size_t>(field.data() + field.size() - joined.back().data())};
    else
      joined.push_back(field);
  fields = std::move(joined);
}

// Names and units from the lines above the first row of numbers. `closed`: rows end with a delimiter, behind which a
// heading may have a name, of a column that is empty.
void readHeader(const std::vector<std::string_view>& lines, bool closed, std::size_t headLine, TableLayout& layout) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> rowLines;  // from 1
  std::vector<std::string_view> fields;
  for (std::size_t i = headLine > 0 ? headLine - 1 : 0; i < layout.firstLine; ++i) {
    splitRow(withoutMarker(lines[i]), layout, fields);
    if (fields.size() > layout.fields) joinUnits(fields, layout);
    if (closed && fields.size() == layout.fields + 1) fields.pop_back();
    if (fields.size() != layout.fields && i + 1 == headLine) return;
    if (fields.size() != layout.fields) continue;
    auto& row = rows.emplace_back();
    rowLines.push_back(i + 1);
    for (const auto field : fields) row.push_back(asUtf8(trimmed(field)));
    if (headLine > 0 && i + 1 > headLine) break;  // the line below it may hold the units
  }
  if (rows.empty()) return;
  const auto unitsOnly = [](const std::vector<std::string>& row) {
    return std::all_of(row.begin(), row.end(), [](const std::string& text) { return text.empty() || isUnit(text); }) &&
           std::any_of(row.begin(), row.end(), [](const std::string& text) { return !text.empty(); });
  };
  std::vector<std::string> units(layout.fields);
  if (rows.size() > 1 && unitsOnly(rows.back())) {
    units = rows.back();
    rows.pop_back();
  }
  if (headLine > 0) rows.resize(1);
  // Remarks between a heading with units and the numbers may have as many fields.
  const auto namesUnits = [&](std::size_t row) {
    return std::any_of(rows[row].begin(), rows[row].end(), [](const auto& f) { return !headingOf(f).unit.empty(); });
  };
  std::size_t names = rows.size() - 1;
  while (headLine == 0 && names > 0 && isComment(lines[rowLines[names] - 1]) && !namesUnits(names)) --names;
  if (namesUnits(names)) rows.resize(names + 1);
  layout.headLine = rowLines[rows.size() - 1];
  for (std::size_t column = 0; column < layout.fields; ++column) {
    // A unit in the row of units stands before one that the name may end with.
    const auto heading = units[column].empty() ? headingOf(rows.back()[column]) : bracketedHeading(rows.back()[column]);
    layout.names.push_back(heading.name);
    layout.units.push_back(heading.unit.empty() ? bareUnit(units[column]) : heading.unit);
  }
}

}  // namespace

void splitRow(std::string_view line, const TableLayout& layout, std::vector<std::string_view>& fields) {
  splitFields(line, layout.delimiter, fields);
  while (fields.size() > layout.fields && trimmed(fields.back()).empty()) fields.pop_back();
}

TableLayout findLayout(const std::vector<std::string_view>& lines, char delimiter, char decimal, std::size_t headLine) {
  std::vector<Candidate> candidates;
  for (const char one : {';', '\t', '|', ',', ' '}) {
    if (delimiter != 0 && delimiter != one) continue;
    for (const char point : {'.', ','})
      if (decimal == 0 || decimal == point) candidates.push_back(judge(lines, one, point));
  }
  if (delimiter != 0 && std::string_view(";\t|, ").find(delimiter) == std::string_view::npos)
    for (const char point : {'.', ','})
      if (decimal == 0 || decimal == point) candidates.push_back(judge(lines, delimiter, point));
  TableLayout layout;
  if (candidates.empty()) return layout;
  Candidate best = candidates.front();
  for (const auto& candidate : candidates)
    if (better(candidate, best)) best = candidate;
  if (best.lines == 0) return layout;
  layout.delimiter = best.delimiter;
  layout.decimal = best.decimal;
  layout.fields = best.closed ? best.fields - 1 : best.fields;
  // Columns of numbers are those of the last line; the table begins with the first line that has numbers there.
  std::vector<std::string_view> fields;
  const auto last = std::find_if(lines.rbegin(), lines.rend(), [](auto line) { return !isComment(line); });
  splitRow(*last, layout, fields);
  for (const auto field : fields) {
    const bool number = isPlainNumber(field, layout.decimal);
    const auto moment = number ? std::nullopt : momentIn(field);
    layout.moments.push_back(moment ? std::optional(moment->kind) : std::nullopt);
    layout.numeric.push_back(number || moment || isMissing(field));
  }
  for (layout.firstLine = headLine; layout.firstLine < lines.size(); ++layout.firstLine) {
    if (isComment(lines[layout.firstLine])) continue;
    splitRow(lines[layout.firstLine], layout, fields);
    if (fields.size() != layout.fields) continue;
    bool row = false, text = false;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (!layout.numeric[i]) continue;
      const bool number =
          layout.moments[i] ? momentIn(fields[i]).has_value() : isPlainNumber(fields[i], layout.decimal);
      row = row || number;
      text = text || !(number || isMissing(fields[i]));
    }
    if (row && !text) break;
  }
  if (layout.firstLine < lines.size()) readHeader(lines, best.closed, headLine, layout);
  return layout;
}

}  // namespace squat::text
