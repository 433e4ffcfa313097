#include "commands/ValidationText.h"

#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::commands {

namespace {

using text::kTerminalWidth;
using text::roundedText;
using text::TextTable;

using statements::Verdict;

std::string stated(const std::string& value, const std::string& unit) {
  return unit == "1" || unit.empty() ? value : value + " " + unit;
}

std::string markText(const statements::SensitivityRow& row, std::size_t statement) {
  if (!row.message.empty()) return row.message;
  return (row.numbers[statement] ? roundedText(*row.numbers[statement]) : "none") + (row.met[statement] ? "" : " *");
}

// The statements down, the values of one input across.
std::string inputText(const statements::SensitivityTable& table, const std::vector<statements::SensitivityRow>& rows) {
  std::vector<std::string> head{"statement", "accepted"};
  for (const auto& row : rows) head.push_back(stated(row.value, row.unit) + (row.base ? " (base)" : ""));
  TextTable text(head);
  for (std::size_t i = 0; i < table.statements.size(); ++i) {
    std::vector<std::string> cells{table.statements[i].name, statements::rangeText(table.statements[i])};
    for (const auto& row : rows) cells.push_back(i < row.numbers.size() ? markText(row, i) : row.message);
    text.add(cells);
  }
  return rows.front().text + " (" + rows.front().key + ")\n" + text.text(kTerminalWidth) + "\n";
}

}  // namespace

std::string countsText(const std::vector<statements::Judged>& judged) {
  return std::to_string(countOf(judged, Verdict::met)) + " met, " + std::to_string(countOf(judged, Verdict::notMet)) +
         " not met, " + std::to_string(countOf(judged, Verdict::notJudged)) + " not judged";
}

// A ratio is a pure number.
std::string valueText(const statements::Judged& one) {
  const auto& unit = one.statement.unit;
  return one.value ? roundedText(*one.value, unit == "ratio" ? "" : unit) : "none";
}

std::string statementsText(const std::vector<statements::Judged>& judged) {
  TextTable table({"section", "statement of the paper", "result", "accepted", "verdict"});
  for (const auto& one : judged)
    table.add({one.statement.section, one.statement.name, valueText(one), statements::rangeText(one.statement),
               statements::toText(one.verdict)});
  return table.text(kTerminalWidth) + reasonsText(judged);
}

std::string reasonsText(const std::vector<statements::Judged>& judged) {
  std::string reasons;
  for (const auto& one : judged) {
    if (one.value || one.why.empty()) continue;
    TextTable reason({one.statement.name + ": " + one.why});
    const auto text = reason.text(kTerminalWidth);
    reasons += text.substr(0, text.rfind('\n', text.size() - 2) + 1);  // without the line below a head
  }
  return reasons.empty() ? "" : "\n" + reasons;
}

std::string parametersText(const std::vector<statements::ComparedParameter>& parameters) {
  TextTable table({"section", "parameter of the paper", "paper", "this run", "key"});
  int same = 0;
  for (const auto& one : parameters) {
    same += one.same ? 1 : 0;
    if (!one.same)
      table.add({one.parameter.section, one.parameter.text, stated(one.parameter.value, one.unit),
                 stated(one.ours, one.unit), one.parameter.key});
  }
  std::string text =
      std::to_string(same) + " of " + std::to_string(parameters.size()) + " model parameters match the paper";
  return table.empty() ? text + ".\n" : text + "; the others:\n\n" + table.text(kTerminalWidth);
}

std::string numbersText(const statements::Reference& reference) {
  TextTable table({"section", "stated by the paper, not judged", "value"});
  for (const auto& one : reference.numbers) table.add({one.section, one.text, stated(one.value, one.unit)});
  return table.text(kTerminalWidth);
}

std::string sensitivityText(const statements::SensitivityTable& table) {
  std::string text;
  std::vector<statements::SensitivityRow> same;  // rows of one key stand together
  for (const auto& row : table.rows) {
    if (!same.empty() && same.front().key != row.key) {
      text += inputText(table, same);
      same.clear();
    }
    same.push_back(row);
  }
  if (!same.empty()) text += inputText(table, same);
  return text + "* not met\n";
}

}  // namespace squat::commands
