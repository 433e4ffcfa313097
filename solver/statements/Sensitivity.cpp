#include "statements/Sensitivity.h"

#include <algorithm>
#include <cmath>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"
#include "statements/Judge.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::statements {

namespace {

std::vector<Statement> statementsOn(const Reference& reference) {
  std::vector<Statement> chosen;
  for (const auto& statement : reference.statements)
    if (statement.run == reference.sensitivityRun && statement.against.empty() && statement.mesh.empty() &&
        statement.measure != "none")
      chosen.push_back(statement);
  return chosen;
}

std::string columnOf(const Statement& statement) {
  return statement.name + (statement.unit.empty() || statement.unit == "1" ? "" : " [" + statement.unit + "]");
}

studies::FeatureRow judgedRow(const std::vector<Statement>& statements, const results::RunResult& result) {
  Reference only;
  only.statements = statements;
  studies::FeatureRow row;
  for (const auto& one : judge(only, {{statements.front().run, result}}, ""))
    row.emplace_back(columnOf(one.statement), one.value.value_or(std::nan("")));
  return row;
}

SensitivityRow rowOf(const std::vector<Statement>& statements, const SensitivityKey& key,
                     const studies::StudyRow& ended) {
  SensitivityRow row{key.key, key.text, ended.point.values.front(), {}, false, {}, {}, ended.message};
  if (ended.state == studies::RowState::open) row.message = "not run";
  for (const auto& statement : statements) {
    std::optional<double> number;
    for (const auto& [name, value] : ended.features)
      if (name == columnOf(statement) && !std::isnan(value)) number = value;
    row.numbers.push_back(number);
    row.met.push_back(number && *number >= statement.low && *number <= statement.high);
  }
  return row;
}

// Whether a point of the study is the case as it stands. A value that no case can have is none, and has been reported.
bool isBase(const studies::StudyDefinition& definition, const cases::CaseOverrides& own,
            const studies::StudyPoint& point, const cases::Parameter& parameter,
            const cases::CaseDescription& description) {
  try {
    return cases::valueText(studies::caseAt(definition, own, point), parameter) ==
           cases::valueText(description, parameter);
  } catch (const CaseError&) {
    return false;
  }
}

}  // namespace

SensitivityTable sensitivity(const Reference& reference, const cases::CaseOverrides& overrides,
                             const studies::CaseRunner& run, const studies::StudyOptions& options, Monitor& monitor) {
  SensitivityTable table{statementsOn(reference), {}};
  const auto* base = reference.run(reference.sensitivityRun);
  if (!base || table.statements.empty() || reference.sensitivity.empty())
    throw CaseError({{"reference", reference.sensitivityRun, "a run with statements, and keys to vary",
                      "The reference lists no run or no keys for the sensitivity"}});
  auto own = overrides;
  own.values.insert(own.values.begin(), base->sets.begin(), base->sets.end());
  const auto description = cases::loadCase(base->caseName, own);
  for (const auto& key : reference.sensitivity) {
    std::string values;
    for (const auto& value : key.values) values += (values.empty() ? "" : ",") + value;
    const auto definition = studies::studyOf(base->caseName, own, {key.key + "=" + values});
    auto folder = options;
    folder.folder += "/" + key.key;
    const studies::StudyRunner runner = [&](const studies::StudyPoint& point,
                                            Monitor& monitorOfRun) -> std::optional<studies::FeatureRow> {
      const auto result = run(studies::caseAt(definition, own, point), point, monitorOfRun);
      if (!result.complete) return std::nullopt;
      return judgedRow(table.statements, result);
    };
    const auto* parameter = cases::findParameter(key.key);
    for (const auto& ended : studies::runStudy(definition, runner, folder, monitor).rows) {
      auto row = rowOf(table.statements, key, ended);
      row.unit = parameter->unit == "-" ? "" : parameter->unit;
      row.base = isBase(definition, own, ended.point, *parameter, description);
      table.rows.push_back(std::move(row));
    }
    if (monitor.cancelled()) break;
  }
  return table;
}

std::string sensitivityCsv(const SensitivityTable& table) {
  using text::csvField;
  std::string text = "key,value,unit,base";
  for (const auto& statement : table.statements) text += "," + csvField(columnOf(statement)) + ",met";
  text += ",message\n";
  for (const auto& row : table.rows) {
    text += row.key + "," + csvField(row.value) + "," + csvField(row.unit) + "," + (row.base ? "yes" : "no");
    for (std::size_t i = 0; i < row.numbers.size(); ++i)
      text += "," + (row.numbers[i] ? text::numberText(*row.numbers[i]) : "") + "," + (row.met[i] ? "yes" : "no");
    text += "," + csvField(row.message) + "\n";
  }
  return text;
}

}  // namespace squat::statements
