// The appendix of a report: files and versions, every feature and every key.
#include <algorithm>
#include <cmath>

#include "analysis/FeatureTable.h"
#include "case/Applicability.h"
#include "case/ParameterValue.h"
#include "project/ReportParts.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::project {
namespace {

constexpr const char* noValue = "-";

std::string scalarText(const std::vector<results::Scalar>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& each) { return each.name == name; });
  return found == list.end() || std::isnan(found->value) ? noValue : text::roundedText(found->value);
}

ReportTable runTable(const Report& report) {
  ReportTable table{"Runs", {"run", "mesh", "elements", "computed (UTC)", "in [s]", "version", "case", "file"}, {}};
  for (const auto& signal : report.signals) {
    if (!signal.result) continue;
    const auto& run = *signal.result;
    const std::string mesh = meshOf(signal);
    const std::string version = run.commit.empty() ? run.codeVersion : run.codeVersion + " (" + run.commit + ")";
    table.rows.push_back({signal.name + (run.complete ? "" : " (incomplete)"), mesh.empty() ? noValue : mesh,
                          scalarText(run.meshFigures, "elements"), run.created, scalarText(run.performance, "seconds"),
                          version, run.caseHash.substr(0, 8), signal.file.empty() ? "not saved" : signal.file});
  }
  return table;
}

ReportTable measuredTable(const Report& report) {
  ReportTable table{"Measured signals", {"signal", "file"}, {}};
  for (const auto& signal : report.signals)
    if (!signal.result) table.rows.push_back({signal.name, signal.file});
  return table;
}

// The title says which axle box it is; the name of its signal says nothing outside of the program.
std::string withoutSignalNames(std::string meaning) {
  for (const std::string name :
       {"second_aba_right_filtered", "second_aba_filtered", "aba_right_filtered", "aba_filtered"})
    if (const auto at = meaning.find(name); at != std::string::npos)
      meaning.replace(at, name.size(), "the low-passed acceleration");
  return meaning;
}

ReportTable featuresTable(const ReportSignal& signal) {
  ReportTable table{"Features of " + signal.name, {"feature", "value", "unit", "meaning"}, {}};
  for (const auto& feature : featuresOf(*signal.result))
    if (!std::isnan(feature.value))
      table.rows.push_back({analysis::featureTitle(feature.name), text::roundedText(feature.value),
                            text::printedUnit(feature.unit), withoutSignalNames(feature.description)});
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

std::vector<ReportTable> appendixTables(const Report& report) {
  std::vector<ReportTable> tables{runTable(report), measuredTable(report), otherEvents(report)};
  if (report.shown >= 0) {
    const auto& shown = report.signals.at(static_cast<std::size_t>(report.shown));
    tables.push_back(featuresTable(shown));
    if (const auto* description = descriptionOf(shown)) tables.push_back(caseTable(shown, *description));
  }
  std::erase_if(tables, [](const auto& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace squat::project
