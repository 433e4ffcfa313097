#include "commands/ValidationText.h"

#include "commands/TextTable.h"

namespace squat::commands {

std::string countsText(const std::vector<validation::Judged>& judged) {
  using validation::Verdict;
  return std::to_string(countOf(judged, Verdict::met)) + " met, " + std::to_string(countOf(judged, Verdict::notMet)) +
         " not met, " + std::to_string(countOf(judged, Verdict::notJudged)) + " not judged";
}

std::string statementsText(const std::vector<validation::Judged>& judged) {
  TextTable table({"section", "the paper states", "ours", "counts as met", "", "judged at", "wheel centre", "run"});
  for (const auto& one : judged) {
    const auto& s = one.statement;
    table.add({s.section, s.text,
               one.value         ? number(*one.value, s.unit)
               : one.why.empty() ? "none"
                                 : one.why,
               validation::rangeText(s), validation::toText(one.verdict), s.point,
               one.elsewhere ? number(*one.elsewhere, s.unit) : "",
               s.run + (s.against.empty() ? "" : " / " + s.against)});
  }
  return table.text();
}

std::string parametersText(const std::vector<validation::ComparedParameter>& parameters) {
  TextTable table({"section", "parameter of the paper's model", "paper", "ours", ""});
  int same = 0;
  for (const auto& one : parameters) {
    same += one.same ? 1 : 0;
    const std::string unit = one.unit.empty() ? "" : " " + one.unit;
    if (!one.same)
      table.add(
          {one.parameter.section, one.parameter.text, one.parameter.value + unit, one.ours + unit, one.parameter.key});
  }
  std::string text = std::to_string(same) + " of " + std::to_string(parameters.size()) +
                     " parameters of the paper's model are as the paper states them";
  return table.empty() ? text + ".\n" : text + "; the others:\n\n" + table.text();
}

std::string numbersText(const validation::Reference& reference) {
  TextTable table({"section", "stated by the paper, not judged", "value"});
  for (const auto& one : reference.numbers)
    table.add({one.section, one.text, one.value + (one.unit == "1" || one.unit.empty() ? "" : " " + one.unit)});
  return table.text();
}

std::string sensitivityText(const validation::SensitivityTable& table) {
  std::vector<std::string> head{"input", "value"};
  for (const auto& statement : table.statements) head.push_back(statement.name);
  TextTable text(head);
  std::vector<std::string> ranges{"", "counts as met"};
  for (const auto& statement : table.statements) ranges.push_back(validation::rangeText(statement));
  text.add(ranges);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells{row.text,
                                   row.value + (row.unit.empty() ? "" : " " + row.unit) + (row.base ? " (base)" : "")};
    for (std::size_t i = 0; i < row.numbers.size(); ++i)
      cells.push_back(!row.message.empty() ? row.message
                      : row.numbers[i]     ? number(*row.numbers[i]) + (row.met[i] ? "" : " *")
                                           : "none *");
    text.add(cells);
  }
  return text.text() + "* not met\n";
}

}  // namespace squat::commands
