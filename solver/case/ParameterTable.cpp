#include "case/ParameterTable.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "case/Applicability.h"
#include "case/DecimalNumber.h"
#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/ParameterLevels.h"
#include "case/ParameterRows.h"
#include "case/ParameterValue.h"

namespace squat::cases {

namespace rows {

namespace {

std::string groupOf(const std::string& key) {
  const auto dot = key.find('.');
  return dot == std::string::npos ? "case" : key.substr(0, dot);
}

Parameter row(const char* key, Kind kind, Access access, const char* doc, const char* source) {
  Parameter parameter;
  parameter.key = key;
  parameter.group = groupOf(parameter.key);
  parameter.kind = kind;
  parameter.access = std::move(access);
  parameter.doc = doc;
  parameter.source = source;
  return parameter;
}

}  // namespace

Parameter number(const char* key, Unit unit, double defaultValue, Range range, double& (*access)(CaseDescription&),
                 const char* doc, const char* source) {
  Parameter parameter = row(key, Kind::number, access, doc, source);
  parameter.unit = unit.name;
  parameter.powerOfTen = unit.power;
  parameter.defaultValue = defaultValue;
  parameter.minimum = range.minimum;
  parameter.maximum = range.maximum;
  parameter.defaultText = formatDecimal(defaultValue);
  return parameter;
}

Parameter wholeNumber(const char* key, double defaultValue, Range range, Access access, const char* doc,
                      const char* source) {
  Parameter parameter = number(key, none, defaultValue, range, nullptr, doc, source);
  parameter.access = std::move(access);
  parameter.integer = true;
  return parameter;
}

Parameter choice(const char* key, std::vector<std::string> names, std::size_t defaultValue, ChoiceAccess access,
                 const char* doc, const char* source) {
  Parameter parameter = row(key, Kind::choice, std::move(access), doc, source);
  parameter.defaultText = names.at(defaultValue);
  parameter.choices = std::move(names);
  return parameter;
}

Parameter inputPreset(const char* key, std::string& (*access)(CaseDescription&), const char* doc, const char* source) {
  const auto& names = inputPresetNames(key);
  // The accessor takes a mutable description; reading through it does not change it.
  return choice(key, names, 0,
                ChoiceAccess{[access, &names](const CaseDescription& description) {
                               const auto& own = access(const_cast<CaseDescription&>(description));
                               const auto found = std::find(names.begin(), names.end(), own);
                               return found == names.end() ? 0 : static_cast<std::size_t>(found - names.begin());
                             },
                             [access, &names](CaseDescription& description, std::size_t index) {
                               access(description) = names.at(index);
                             }},
                doc, source);
}

Parameter boolean(const char* key, bool defaultValue, bool& (*access)(CaseDescription&), const char* doc,
                  const char* source) {
  Parameter parameter = row(key, Kind::boolean, access, doc, source);
  parameter.defaultText = defaultValue ? "true" : "false";
  return parameter;
}

Parameter text(const char* key, std::string& (*access)(CaseDescription&), const char* doc, const char* source) {
  return row(key, Kind::text, access, doc, source);
}

Parameter points(const char* key, std::vector<ProfilePoint>& (*access)(CaseDescription&), const char* doc,
                 const char* source) {
  Parameter parameter = row(key, Kind::points, access, doc, source);
  parameter.unit = millimetre.name;
  parameter.powerOfTen = millimetre.power;
  return parameter;
}

Parameter lines(const char* key, std::vector<ProfileLine>& (*access)(CaseDescription&), const char* doc,
                const char* source) {
  Parameter parameter = row(key, Kind::lines, access, doc, source);
  parameter.unit = millimetre.name;
  parameter.powerOfTen = millimetre.power;
  return parameter;
}

Parameter forceCurve(const char* key, std::vector<ForcePoint>& (*access)(CaseDescription&), const char* doc,
                     const char* source) {
  Parameter parameter = row(key, Kind::forceCurve, access, doc, source);
  parameter.unit = "mm, kN";
  parameter.defaultText = "[]";
  return parameter;
}

Parameter seats(const char* key, std::vector<Seat>& (*access)(CaseDescription&), const char* doc, const char* source) {
  Parameter parameter = row(key, Kind::seats, access, doc, source);
  parameter.defaultText = "[]";
  return parameter;
}

namespace {

Parameter withRequirement(const Requirement& requirement, Parameter parameter) {
  if (parameter.condition.empty()) parameter.condition.emplace_back();
  for (auto& alternative : parameter.condition) alternative.insert(alternative.begin(), requirement);
  return parameter;
}

}  // namespace

Parameter appliesIf(const char* key, std::vector<std::string> values, Parameter parameter) {
  return withRequirement({key, Requirement::Relation::isOneOf, std::move(values)}, std::move(parameter));
}

Parameter appliesUnless(const char* key, std::vector<std::string> values, Parameter parameter) {
  return withRequirement({key, Requirement::Relation::isNot, std::move(values)}, std::move(parameter));
}

}  // namespace rows

namespace {

using Case = CaseDescription;

std::vector<Parameter> makeTable() {
  std::vector<Parameter> table;
  table.push_back(rows::text(
      "title", [](Case& c) -> std::string& { return c.title; }, "name of the case, shown on figures", "free text"));
  table.push_back(rows::text(
      "note", [](Case& c) -> std::string& { return c.note; }, "anything worth keeping with the case", "free text"));
  for (const auto& part : {rows::defectRows(), rows::motionRows(), rows::trackRows(), rows::vehicleRows(),
                           rows::runRows(), rows::growthRows()})
    table.insert(table.end(), part.begin(), part.end());
  // What a preset sets has the value of the preset draft as its default; the rows need not repeat it.
  for (const auto& preset : presetTable())
    for (auto& parameter : table)
      if (parameter.key == preset.key) {
        parameter.defaultText = preset.values[static_cast<std::size_t>(MeshPreset::draft)];
        parameter.defaultValue = parseDecimal(parameter.defaultText).value_or(parameter.defaultValue);
      }
  for (auto& parameter : table) parameter.level = levelOf(parameter.key);
  for (auto& parameter : table)
    if (!parameter.condition.empty()) parameter.doc += "; applies if " + conditionText(parameter.condition);
  return table;
}

}  // namespace

const std::vector<Parameter>& parameterTable() {
  static const std::vector<Parameter> table = makeTable();
  return table;
}

const Parameter* findParameter(std::string_view key) {
  static const auto index = [] {
    std::unordered_map<std::string_view, const Parameter*> map;
    for (const auto& parameter : parameterTable()) map.emplace(parameter.key, &parameter);
    return map;
  }();
  const auto found = index.find(key);
  return found == index.end() ? nullptr : found->second;
}

int editDistance(std::string_view a, std::string_view b) {
  std::vector<int> previous(b.size() + 1), current(b.size() + 1);
  std::iota(previous.begin(), previous.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    current[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
      current[j + 1] = std::min({previous[j] + (a[i] != b[j]), previous[j + 1] + 1, current[j] + 1});
    std::swap(previous, current);
  }
  return previous[b.size()];
}

std::string nearestKey(std::string_view key) {
  if (key.size() > 100) return {};
  std::string nearest;
  int smallest = 2 + static_cast<int>(key.size()) / 4;  // farther than that is another word
  for (const auto& parameter : parameterTable()) {
    int distance = editDistance(key, parameter.key);
    // The right name in a wrong or missing table.
    if (lastPart(key) == lastPart(parameter.key)) distance = std::min(distance, 1);
    if (distance < smallest) {
      smallest = distance;
      nearest = parameter.key;
    }
  }
  return nearest;
}

CaseDescription defaultCase() {
  CaseDescription description;
  for (const auto& parameter : parameterTable()) setToDefault(description, parameter);
  return description;
}

}  // namespace squat::cases
