// The tables of a report.
#include <algorithm>
#include <cmath>

#include "analysis/ComparisonTable.h"
#include "analysis/FeatureTable.h"
#include "case/Applicability.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "project/Report.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::project {
namespace {

constexpr std::size_t comparedInATable = 4;  // columns that a page holds beside the names

std::string scalarText(const std::vector<results::Scalar>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& each) { return each.name == name; });
  return found == list.end() ? "-" : text::roundedText(found->value);
}

const cases::CaseDescription* descriptionOf(const ReportSignal& signal) {
  return signal.result && signal.result->resolvedCase ? &signal.result->resolvedCase->description : nullptr;
}

std::string meshOf(const ReportSignal& signal) {
  const auto* description = descriptionOf(signal);
  return description ? cases::valueText(*description, *cases::findParameter("mesh.preset")) : "-";
}

ReportTable signalsTable(const Report& report) {
  ReportTable table{"Runs and measured signals",
                    {"name", "mesh", "elements", "computed (UTC)", "in [s]", "version", "case", "file"},
                    {}};
  for (const auto& signal : report.signals) {
    const std::string file = signal.file.empty() ? "not saved" : signal.file;
    if (!signal.result) {
      table.rows.push_back({signal.name, "measured", "-", "-", "-", "-", "-", file});
      continue;
    }
    const auto& run = *signal.result;
    const std::string version = run.commit.empty() ? run.codeVersion : run.codeVersion + " (" + run.commit + ")";
    table.rows.push_back({signal.name + (run.complete ? "" : " (incomplete)"), meshOf(signal),
                          scalarText(run.meshFigures, "elements"), run.created, scalarText(run.performance, "seconds"),
                          version, run.caseHash.substr(0, 8), file});
  }
  return table;
}

// What the studio's comparison shows: of a measured signal the whole file counts, of which a piece is drawn.
analysis::ComparisonTable comparisonOf(const Report& report, std::vector<std::string>& problems) {
  const auto whole = [](const ReportSignal& signal) {
    return signal.result ? *signal.record : wholeRecord({signal.record, signal.reading});
  };
  std::vector<cases::ComparedCase> cases(report.signals.size());
  std::vector<analysis::ComparedSignal> compared;
  for (std::size_t i = 0; i < report.signals.size(); ++i) {
    const auto& signal = report.signals[i];
    const auto* description = descriptionOf(signal);
    if (description) cases[i] = cases::comparedCase(*description);
    analysis::ComparedSignal row{signal.name, description ? &cases[i] : nullptr, {}, {}};
    try {
      const auto record = whole(signal);
      row.numbers = analysis::signalNumbers(record);
      if (report.reference >= 0)
        row.likeness =
            analysis::likenessNumbers(record, whole(report.signals[static_cast<std::size_t>(report.reference)]));
    } catch (const std::exception& error) {
      problems.push_back(signal.name + ": " + error.what());
    }
    compared.push_back(std::move(row));
  }
  return analysis::comparisonTable(compared);
}

// Turned: a row a quantity, which has room for its name.
void addComparison(const Report& report, std::vector<ReportTable>& tables, std::vector<std::string>& problems) {
  if (report.signals.size() < 2) return;
  const auto comparison = comparisonOf(report, problems);
  std::string heading = "Comparison";
  if (report.reference >= 0)
    heading +=
        " (correlation and peak ratio: with " + report.signals[static_cast<std::size_t>(report.reference)].name + ")";
  for (std::size_t first = 0; first < comparison.rows.size(); first += comparedInATable) {
    const std::size_t last = std::min(first + comparedInATable, comparison.rows.size());
    ReportTable table{first == 0 ? heading : "Comparison, continued", {"quantity"}, {}};
    for (std::size_t signal = first; signal < last; ++signal) table.columns.push_back(comparison.rows[signal][0].text);
    for (std::size_t quantity = 1; quantity < comparison.columns.size(); ++quantity) {
      std::vector<std::string> row{text::withPrintedUnit(comparison.columns[quantity])};
      for (std::size_t signal = first; signal < last; ++signal) row.push_back(comparison.rows[signal][quantity].text);
      table.rows.push_back(std::move(row));
    }
    tables.push_back(std::move(table));
  }
}

ReportTable featuresTable(const ReportSignal& signal) {
  ReportTable table{"Features of " + signal.name, {"feature", "value", "unit", "meaning"}, {}};
  const auto& run = *signal.result;
  for (const auto& feature : run.features.empty() ? analysis::featureScalars(run) : run.features)
    table.rows.push_back({feature.name, std::isnan(feature.value) ? "-" : text::roundedText(feature.value),
                          text::printedUnit(feature.unit), feature.description});
  return table;
}

// A drawn shape may have hundreds of points.
std::string shortened(const std::string& value) {
  constexpr std::size_t longest = 160;
  return value.size() <= longest ? value : value.substr(0, longest) + " ... (whole in the result file)";
}

ReportTable caseTable(const ReportSignal& signal, const cases::CaseDescription& description) {
  ReportTable table{"Case of " + signal.name, {"key", "value", "unit", "meaning"}, {}};
  for (const auto& parameter : cases::parameterTable()) {
    if (!cases::applies(description, parameter)) continue;
    const bool empty = cases::isList(parameter) && cases::isEmptyList(description, parameter);
    const std::string value = cases::valueText(description, parameter);
    if (empty || value.empty() || value == "[]") continue;
    table.rows.push_back({parameter.key, shortened(value),
                          parameter.unit == "-" ? "" : text::printedUnit(parameter.unit), parameter.doc});
  }
  return table;
}

}  // namespace

std::vector<ReportTable> reportTables(const Report& report, std::vector<std::string>& problems) {
  std::vector<ReportTable> tables{signalsTable(report)};
  addComparison(report, tables, problems);
  if (report.shown < 0) return tables;
  const auto& shown = report.signals.at(static_cast<std::size_t>(report.shown));
  tables.push_back(featuresTable(shown));
  if (const auto* description = descriptionOf(shown)) tables.push_back(caseTable(shown, *description));
  return tables;
}

}  // namespace squat::project
