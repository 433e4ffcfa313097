// The summary of a report, and the inputs that are no defaults.
#include <algorithm>
#include <cmath>

#include "analysis/FeatureTable.h"
#include "analysis/WheelForces.h"
#include "case/CaseDescription.h"
#include "case/CaseNames.h"
#include "case/DecimalNumber.h"
#include "case/ParameterTable.h"
#include "project/ReportParts.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::project {
namespace {

constexpr std::size_t comparedInATable = 4;  // columns that a page holds beside the names
constexpr const char* noNumber = "-";

std::string capitalised(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

// "Depth [mm]", "Right pad stiffness [MN/m]": a row of cases::comparedCase().
std::string inputTitle(std::size_t row) {
  const auto& parameter = cases::comparedParameter(row);
  if (parameter.key == "mesh.preset") return "Mesh";
  const bool bare = parameter.unit.empty() || parameter.unit == "-" || cases::isList(parameter);
  const std::string label = cases::comparedLabel(row);
  return (parameter.group == "mesh" ? "Mesh " + label : capitalised(label)) +
         (bare ? "" : " [" + text::printedUnit(parameter.unit) + "]");
}

// As a case file states it, for people: without its underscores, yes and no.
std::string inputText(const cases::Parameter& parameter, const std::string& value) {
  if (parameter.kind == cases::Kind::boolean) return value == "true" ? "yes" : value == "false" ? "no" : value;
  std::string words = value;
  if (parameter.kind == cases::Kind::choice) std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

bool isSameInput(const std::string& one, const std::string& other) {
  const auto a = cases::parseDecimal(one), b = cases::parseDecimal(other);
  return one == other || (a && b && *a == *b);
}

// What is known of the cases of the runs; one a signal, empty where nothing is.
struct KnownCases {
  std::vector<cases::ComparedCase> all;
  std::vector<const cases::ComparedCase*> known;
};
KnownCases knownCases(const Report& report) {
  KnownCases found;
  for (const auto& signal : report.signals) {
    const auto* description = descriptionOf(signal);
    found.all.push_back(description ? cases::comparedCase(*description) : cases::ComparedCase());
  }
  for (const auto& each : found.all)
    if (!each.empty()) found.known.push_back(&each);
  return found;
}

struct SummaryRow {
  std::string title;
  std::vector<std::string> cells;  // one a signal
};

void addInputs(const KnownCases& cases, std::vector<SummaryRow>& rows) {
  for (const std::size_t row : cases::differingRows(cases.known)) {
    SummaryRow added{inputTitle(row), {}};
    for (const auto& each : cases.all) {
      const std::string value = each.empty() ? std::string() : each[row].shown;
      added.cells.push_back(value.empty() ? noNumber : inputText(cases::comparedParameter(row), value));
    }
    rows.push_back(std::move(added));
  }
}

double numberNamed(const analysis::NamedNumbers& numbers, const std::string& name) {
  const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const auto& each) { return each.first == name; });
  return found == numbers.end() ? NAN : found->second;
}

// Title, unit and factor to it of a number of analysis::signalNumbers().
struct PrintedNumber {
  std::string title;
  double factor = 1;
};
PrintedNumber printedNumber(const std::string& name) {
  const std::string line = "line ";
  if (name.starts_with(line))
    return {analysis::featureTitle("peak " + name.substr(line.size(), 1) + " frequency") + " [Hz]"};
  if (name.ends_with("[m]")) return {analysis::featureTitle(name) + " [mm]", 1e3};
  const auto unit = name.find('[');
  return {
      text::withPrintedUnit(analysis::featureTitle(name) + (unit == std::string::npos ? "" : " " + name.substr(unit)))};
}

void addNumbers(const std::vector<analysis::NamedNumbers>& numbers, std::vector<SummaryRow>& rows) {
  std::vector<std::string> names;  // each once, in the order in which they come
  for (const auto& each : numbers)
    for (const auto& [name, value] : each)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  for (const auto& name : names) {
    const auto printed = printedNumber(name);
    SummaryRow row{printed.title, {}};
    for (const auto& each : numbers) {
      const double value = numberNamed(each, name);
      row.cells.push_back(std::isnan(value) ? noNumber : text::roundedText(printed.factor * value));
    }
    rows.push_back(std::move(row));
  }
}

// Of each wheel; 0 where it lifts off. A wheel that is alone has no name.
void addSmallestForces(const Report& report, std::vector<SummaryRow>& rows) {
  const std::string title = analysis::featureTitle("smallest_contact_force");
  std::vector<SummaryRow> forces;
  for (std::size_t column = 0; column < report.signals.size(); ++column) {
    if (!report.signals[column].result) continue;
    const auto wheels = analysis::wheelForces(*report.signals[column].result);
    for (const auto& one : wheels) {
      const std::string name = title + (wheels.size() < 2 ? "" : " of the " + one.wheel) + " [kN]";
      auto row = std::find_if(forces.begin(), forces.end(), [&](const auto& each) { return each.title == name; });
      if (row == forces.end())
        row = forces.insert(row, {name, std::vector<std::string>(report.signals.size(), noNumber)});
      row->cells[column] = text::roundedText(1e-3 * one.smallest);
    }
  }
  rows.insert(rows.end(), forces.begin(), forces.end());
}

// Of runs alone: nobody measures it. Where there are several wheels, the largest is that of the first left one.
void addContactForces(const Report& report, std::vector<SummaryRow>& rows) {
  addSmallestForces(report, rows);
  const char* name = "largest_contact_force";
  SummaryRow row{analysis::featureTitle(name), {}};
  bool areSeveral = false;
  for (const auto& signal : report.signals) {
    row.cells.emplace_back(noNumber);
    if (!signal.result) continue;
    areSeveral = areSeveral || analysis::wheelForces(*signal.result).size() > 1;
    for (const auto& feature : featuresOf(*signal.result))
      if (feature.name == name && !std::isnan(feature.value))
        row.cells.back() = text::roundedText(1e-3 * feature.value);
  }
  row.title += areSeveral ? " of the first left wheel [kN]" : " [kN]";
  rows.push_back(std::move(row));
}

void addLikeness(const Report& report, const std::vector<SignalNumbers>& numbers, std::vector<SummaryRow>& rows) {
  if (report.reference < 0 || report.signals.size() < 2) return;
  const std::string reference = report.signals[static_cast<std::size_t>(report.reference)].name;
  for (const auto& [name, title] : {std::pair{"correlation [-]", "Correlation with " + reference},
                                    std::pair{"peak ratio [-]", "Largest acceleration by that of " + reference}}) {
    SummaryRow row{title, {}};
    for (const auto& each : numbers) {
      const double value = numberNamed(each.likeness, name);
      row.cells.push_back(std::isnan(value) ? noNumber : text::roundedText(value));
    }
    rows.push_back(std::move(row));
  }
}

bool saysNothing(const SummaryRow& row) {
  return std::all_of(row.cells.begin(), row.cells.end(), [](const auto& cell) { return cell == noNumber; });
}

}  // namespace

std::vector<ReportTable> summaryTables(const Report& report, const std::vector<SignalNumbers>& numbers) {
  std::vector<analysis::NamedNumbers> named;
  for (const auto& each : numbers)
    named.push_back(each.features ? analysis::signalNumbers(*each.features) : analysis::NamedNumbers());
  std::vector<SummaryRow> rows;
  addInputs(knownCases(report), rows);
  addNumbers(named, rows);
  addContactForces(report, rows);
  addLikeness(report, numbers, rows);
  rows.erase(std::remove_if(rows.begin(), rows.end(), saysNothing), rows.end());
  std::vector<ReportTable> tables;
  if (rows.empty()) return tables;
  for (std::size_t first = 0; first < report.signals.size(); first += comparedInATable) {
    const std::size_t last = std::min(first + comparedInATable, report.signals.size());
    ReportTable table{first == 0 ? "Summary" : "Summary, continued", {"quantity"}, {}};
    for (std::size_t signal = first; signal < last; ++signal) table.columns.push_back(report.signals[signal].name);
    for (const auto& row : rows) {
      std::vector<std::string> cells(row.cells.begin() + static_cast<std::ptrdiff_t>(first),
                                     row.cells.begin() + static_cast<std::ptrdiff_t>(last));
      if (saysNothing({{}, cells})) continue;
      cells.insert(cells.begin(), row.title);
      table.rows.push_back(std::move(cells));
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

ReportTable changedInputs(const Report& report) {
  ReportTable table{"Inputs other than the defaults", {"input", "value", "default"}, {}};
  const auto found = knownCases(report);
  if (found.known.empty()) return table;
  const auto usual = cases::comparedCase(cases::defaultCase());
  auto withUsual = found.known;
  withUsual.push_back(&usual);
  const auto between = cases::differingRows(found.known);  // these are in the summary
  for (const std::size_t row : cases::differingRows(withUsual)) {
    const auto& parameter = cases::comparedParameter(row);
    const std::string value = found.known.front()->at(row).shown;
    const bool isRight = cases::comparedKey(row) != parameter.key;  // the left side is its default
    const bool isUsual = !isRight && isSameInput(value, cases::defaultTextOf(parameter));
    if (value.empty() || isUsual || std::find(between.begin(), between.end(), row) != between.end()) continue;
    const std::string other = isRight                    ? "as on the left"
                              : cases::isList(parameter) ? "none"
                                                         : inputText(parameter, cases::defaultTextOf(parameter));
    table.rows.push_back({inputTitle(row), inputText(parameter, value), other});
  }
  return table;
}

}  // namespace squat::project
