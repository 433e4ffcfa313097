#include "studies/StudySummary.h"

#include <cmath>
#include <limits>

#include "case/ParameterTable.h"
#include "case/RightSide.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::studies {

namespace {

constexpr std::size_t kMaximumRows = 40;

constexpr SummaryFeature kShown[] = {{"peak [m/s2]", "peak [m/s²]", 1},
                                     {"largest moving rms [m/s2]", "max. rms [m/s²]", 1},
                                     {"largest contact force [N]", "max. force [kN]", 1e-3},
                                     {"wavelength by ridge [m]", "wavelength [mm]", 1e3},
                                     {"peak 1 frequency [Hz]", "line 1 [Hz]", 1}};

std::string cellOf(const StudyRow& row, const SummaryFeature& feature) {
  const double value = valueOf(row, feature);
  return std::isnan(value) ? "-" : text::roundedText(value);
}

std::string headOf(const std::string& key) {
  const auto* parameter = cases::findOnEitherSide(key);
  const std::string unit = parameter ? parameter->unit : std::string();
  return unit.empty() || unit == "-" ? key : key + " [" + text::printedUnit(unit) + "]";
}

}  // namespace

std::span<const SummaryFeature> summaryFeatures() { return kShown; }

double valueOf(const StudyRow& row, const SummaryFeature& feature) {
  for (const auto& [name, value] : row.features)
    if (name == feature.name) return feature.factor * value;
  return std::numeric_limits<double>::quiet_NaN();
}

std::string studySummary(const StudyTable& table) {
  std::vector<std::string> head;
  for (const auto& variation : table.definition.variations) head.push_back(headOf(variation.key));
  head.emplace_back("state");
  for (const auto& shown : kShown) head.emplace_back(shown.head);
  text::TextTable lines(head);
  std::size_t rows = 0, ended = 0;
  for (const auto& row : table.rows) {
    if (row.state == RowState::open || ++ended > kMaximumRows) continue;
    std::vector<std::string> cells = row.point.values;
    cells.emplace_back(row.state == RowState::done ? "done" : "failed");
    for (const auto& shown : kShown) cells.push_back(cellOf(row, shown));
    lines.add(cells);
    ++rows;
  }
  if (lines.empty()) return {};
  std::string all = std::string("features anchored at: ") + kStudyAnchor + "\n" + lines.text();
  if (ended > rows) all += "... and " + std::to_string(ended - rows) + " more rows in study.csv\n";
  return all;
}

}  // namespace squat::studies
