#include "calibration/CalibrationSummary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "statements/Judge.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::calibration {

namespace {

using text::kTerminalWidth;
using text::roundedText;
using text::TextTable;

std::string valueCell(const std::optional<double>& value, const std::string& unit) {
  if (!value) return "none";
  return roundedText(*value, unit == "ratio" ? "" : unit);
}

// The targets at the best point, on the mesh of the search and on the finer one.
std::string targetTable(const Calibration& found) {
  const auto& targets = found.definition.targets;
  const auto names = targets.names();
  const auto& search = found.evaluations[found.bestOfSearch];
  const auto& confirmed = found.evaluations[found.best];
  const bool both = confirmed.mesh != search.mesh;
  std::vector<std::string> head{"target", "accepted", search.mesh, ""};
  if (both) head.push_back(confirmed.mesh), head.push_back("");
  TextTable table(head);
  const auto met = [](const TargetValue& value) { return value.isMet ? "met" : "not met"; };
  for (std::size_t t = 0; t < names.size(); ++t) {
    const bool isStatement = t < targets.statements.size();
    const auto* statement = isStatement ? &targets.statements[t].statement : nullptr;
    const std::string unit = statement ? statement->unit : "";
    std::vector<std::string> row{names[t], statement ? statements::rangeText(*statement) : "rms residual at most 1.5"};
    row.push_back(valueCell(search.targets[t].value, unit)), row.push_back(met(search.targets[t]));
    if (both) row.push_back(valueCell(confirmed.targets[t].value, unit)), row.push_back(met(confirmed.targets[t]));
    table.add(row);
  }
  return table.text(kTerminalWidth);
}

std::string remarkOf(const InputRange& range) {
  if (!range.isSeen) return "no effect on the targets";
  if (range.reachesLow && range.reachesHigh) return "not determined: all values between the limits are equally good";
  if (range.reachesLow || range.reachesHigh)
    return std::string("the range ends at the ") + (range.reachesLow ? "lower" : "upper") + " limit of the search";
  return "";
}

std::string inputTable(const Calibration& found) {
  TextTable table({"input", "value", "equally good", "searched", "remark"});
  for (std::size_t i = 0; i < found.ranges.size(); ++i) {
    const auto& input = found.definition.inputs[i];
    const auto& range = found.ranges[i];
    const std::string unit = input.parameter->unit == "-" ? "" : " " + input.parameter->unit;
    const auto span = [&](double low, double high) { return roundedText(low) + " to " + roundedText(high) + unit; };
    table.add({input.key(), roundedText(range.best) + unit, span(range.low, range.high), span(input.low, input.high),
               remarkOf(range)});
  }
  return table.text(kTerminalWidth);
}

// Pairs that the targets hardly part: one can be exchanged for the other.
std::string correlationLines(const Calibration& found) {
  constexpr double strong = 0.7;
  std::string lines;
  for (std::size_t i = 0; i < found.correlation.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const double r = found.correlation[i][k];
      if (std::abs(r) < strong) continue;
      char number[16];
      std::snprintf(number, sizeof number, "%.2f", r);
      lines +=
          "  " + found.definition.inputs[k].key() + " and " + found.definition.inputs[i].key() + ": " + number + "\n";
    }
  return lines.empty() ? lines : "Correlated inputs (only a combination of both is known):\n" + lines;
}

}  // namespace

std::string calibrationSummary(const Calibration& found) {
  if (found.ranges.empty()) return {};
  const auto failed = std::count_if(found.evaluations.begin(), found.evaluations.end(),
                                    [](const Evaluation& row) { return row.hasFailed; });
  std::string text = "Targets\n" + targetTable(found) + "\nInputs\n" + inputTable(found) + "\n";
  if (const auto lines = correlationLines(found); !lines.empty()) text += lines + "\n";
  text += std::to_string(found.evaluations.size()) + " points computed, " + std::to_string(found.equallyGood.size()) +
          " as good as the best on " + found.definition.searchMesh + ", " + std::to_string(failed) +
          " could not be run\n";
  for (const auto& note : found.definition.targets.notes) text += "note: " + note + "\n";
  for (const auto& target : found.outOfReach) text += "out of reach: " + target + "\n";
  return text;
}

}  // namespace squat::calibration
