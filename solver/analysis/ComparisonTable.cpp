#include "analysis/ComparisonTable.h"

#include <algorithm>

#include "analysis/FileComparison.h"
#include "case/DecimalNumber.h"
#include "text/Csv.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::analysis {
namespace {

constexpr std::size_t shownLines = 3;
constexpr const char* nothing = "-";  // as the commands print it

signals::Passage usualPassage(const signals::Record& signal) {
  std::vector<std::string> notes;
  return comparedPassage(signal, FileComparisonOptions().lowPass, notes);
}

// "peak 2 frequency [Hz]" is the second line; of the other names only those that the table shows.
std::string columnOf(const std::string& feature) {
  for (std::size_t line = 1; line <= shownLines; ++line)
    if (feature == "peak " + std::to_string(line) + " frequency [Hz]") return "line " + std::to_string(line) + " [Hz]";
  const bool shown =
      feature.starts_with("peak [") || feature == "wavelength by crossings [m]" || feature.starts_with("power ");
  return shown ? feature : std::string();
}

std::string columnOf(std::size_t comparedRow) {
  const auto& parameter = cases::comparedParameter(comparedRow);
  const std::string label = cases::comparedLabel(comparedRow);
  const bool bare = parameter.unit.empty() || parameter.unit == "-" || cases::isList(parameter);
  return bare ? label : label + " [" + parameter.unit + "]";
}

// Every name once, in the order in which they come.
std::vector<std::string> namesIn(const std::vector<ComparedSignal>& signals, NamedNumbers ComparedSignal::*part) {
  std::vector<std::string> names;
  for (const auto& signal : signals)
    for (const auto& [name, value] : signal.*part)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

ComparisonCell numberCell(const NamedNumbers& numbers, const std::string& name) {
  const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const auto& each) { return each.first == name; });
  if (found == numbers.end() || std::isnan(found->second)) return {nothing, NAN};
  return {text::roundedText(found->second), found->second};
}

ComparisonCell valueCell(const cases::ComparedCase* values, std::size_t row) {
  const std::string shown = values ? (*values)[row].shown : std::string();
  return shown.empty() ? ComparisonCell{nothing, NAN} : ComparisonCell{shown, cases::parseDecimal(shown).value_or(NAN)};
}

std::string withoutBreaks(std::string text) {
  for (char& letter : text)
    if (letter == '\t' || letter == '\n' || letter == '\r') letter = ' ';
  return text;
}

}  // namespace

signals::Features comparedFeatures(const signals::Record& signal) { return signals::features(usualPassage(signal)); }

NamedNumbers signalNumbers(const signals::Record& signal) { return signalNumbers(comparedFeatures(signal)); }

NamedNumbers signalNumbers(const signals::Features& features) {
  NamedNumbers numbers;
  for (const auto& [name, value] : signals::featureRow(features, shownLines))
    if (const std::string column = columnOf(name); !column.empty()) numbers.emplace_back(column, value);
  // The lines right behind the peak.
  std::stable_partition(numbers.begin(), numbers.end(), [](const auto& each) {
    return each.first.starts_with("peak") || each.first.starts_with("line");
  });
  return numbers;
}

signals::Comparison recordComparison(const signals::Record& signal, const signals::Record& reference) {
  return signals::compare(usualPassage(signal), usualPassage(reference));
}

NamedNumbers likenessNumbers(const signals::Record& signal, const signals::Record& reference) {
  NamedNumbers numbers;
  for (const auto& each : signals::comparisonRow(recordComparison(signal, reference)))
    if (each.first == "correlation [-]" || each.first == "peak ratio [-]") numbers.push_back(each);
  return numbers;
}

ComparisonTable comparisonTable(const std::vector<ComparedSignal>& signals) {
  std::vector<const cases::ComparedCase*> known;
  for (const auto& signal : signals)
    if (signal.values) known.push_back(signal.values);
  const auto differing = cases::differingRows(known);
  const auto numbers = namesIn(signals, &ComparedSignal::numbers),
             likeness = namesIn(signals, &ComparedSignal::likeness);
  ComparisonTable table{{"signal"}, {}};
  for (const std::size_t row : differing) table.columns.push_back(columnOf(row));
  table.columns.insert(table.columns.end(), numbers.begin(), numbers.end());
  table.columns.insert(table.columns.end(), likeness.begin(), likeness.end());
  for (const auto& signal : signals) {
    std::vector<ComparisonCell> cells{{signal.name, NAN}};
    for (const std::size_t row : differing) cells.push_back(valueCell(signal.values, row));
    for (const auto& name : numbers) cells.push_back(numberCell(signal.numbers, name));
    for (const auto& name : likeness) cells.push_back(numberCell(signal.likeness, name));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string tableCsv(const ComparisonTable& table) {
  std::string csv;
  for (const auto& column : table.columns) csv += (csv.empty() ? "" : ",") + text::csvField(column);
  for (const auto& row : table.rows) {
    csv += '\n';
    for (std::size_t at = 0; at < row.size(); ++at) {
      const auto& cell = row[at];
      const std::string shown = at > 0 && cell.text == nothing ? std::string() : text::csvField(cell.text);
      csv += (at > 0 ? "," : "") + (std::isnan(cell.number) ? shown : text::numberText(cell.number));
    }
  }
  return csv + "\n";
}

std::string tabbedText(const ComparisonTable& table) {
  std::string lines;
  for (const auto& column : table.columns) lines += (lines.empty() ? "" : "\t") + text::withPrintedUnit(column);
  for (const auto& row : table.rows) {
    lines += '\n';
    for (std::size_t at = 0; at < row.size(); ++at) lines += (at > 0 ? "\t" : "") + withoutBreaks(row[at].text);
  }
  return lines + "\n";
}

}  // namespace squat::analysis
