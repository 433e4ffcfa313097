#include "case/CaseNames.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "case/Applicability.h"
#include "case/DecimalNumber.h"
#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/NamedTables.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"

namespace squat::cases {

namespace {

constexpr std::size_t maximumNamed = 4;  // values in a name: more of them nobody reads in a list

// What a case is called, and where its values are from, change no result.
bool changesResults(const Parameter& parameter) {
  return parameter.key != "title" && parameter.key != "note" && !namesTable(parameter) && !isInputPreset(parameter.key);
}

bool isOfPreset(const CaseDescription& description, const Parameter& parameter, const std::string& text) {
  const auto& rows = presetTable();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return each.key == parameter.key; });
  if (row == rows.end()) return false;
  const auto preset = static_cast<std::size_t>(description.mesh.preset);
  return text == row->values[preset] ||
         (parameter.kind == Kind::number && parseDecimal(text) == parseDecimal(row->values[preset]));
}

// Three digits: what a name can hold of a drawn shape.
std::string threeDigits(double millimetres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", millimetres);
  return text;
}

// The file that it is from, else how deep and long it is.
std::string extentOf(const std::string& file, const std::vector<ProfilePoint>& own,
                     const std::vector<ProfileLine>& lines) {
  if (!file.empty()) return std::filesystem::path(file).stem().string();
  std::vector<const std::vector<ProfilePoint>*> curves{&own};
  for (const auto& line : lines) curves.push_back(&line.points);
  double deepest = 0, first = 0, last = 0;  // [m]
  bool any = false;
  for (const auto* points : curves)
    for (const auto& point : *points) {
      deepest = std::min(deepest, point.height);
      first = any ? std::min(first, point.position) : point.position;
      last = any ? std::max(last, point.position) : point.position;
      any = true;
    }
  return threeDigits(-1e3 * deepest) + " deep, " + threeDigits(1e3 * (last - first)) + " long";
}

ComparedValue comparedValue(const CaseDescription& description, const Parameter& parameter) {
  if (!changesResults(parameter) || !applies(description, parameter)) return {};
  const std::string text = valueText(description, parameter);
  if (isOfPreset(description, parameter, text)) return {};
  if (!isList(parameter)) return {text, text};
  if (isEmptyList(description, parameter)) return {};
  const auto& defect = description.defect;
  const auto& tread = description.tread;
  const auto& rail = description.rail.irregularity;
  if (parameter.group == "rail") return {text, "rail " + extentOf(rail.file, rail.points, {})};
  return {text, parameter.group == "defect" ? extentOf(defect.file, defect.points, defect.lines)
                                            : "tread " + extentOf(tread.file, tread.points, tread.lines)};
}

int importance(const Parameter& parameter) {
  if (parameter.group == "defect") return 0;
  if (parameter.key == "mesh.preset") return 2;
  return parameter.group == "mesh" || parameter.group == "output" ? 3 : 1;
}

bool isRowOfRight(std::size_t row) { return row >= parameterTable().size(); }

// "depth 0.15", "cosine", "no coarse web", "right depth 0.3", "right shape none".
std::string named(std::size_t row, const std::string& shown) {
  const auto& parameter = comparedParameter(row);
  const bool isShape = parameter.key == "defect.shape" && !isRowOfRight(row);
  if (isList(parameter)) return (isRowOfRight(row) ? "right " : "") + shown;
  if (parameter.key == "mesh.preset" || isShape) return shown;
  if (parameter.kind == Kind::boolean) return (shown == "true" ? "" : "no ") + comparedLabel(row);
  return comparedLabel(row) + " " + shown;
}

std::string suggestedName(const CaseToName& one, const std::vector<std::size_t>& rows, bool withStem) {
  std::string name = withStem ? one.stem : std::string();
  std::size_t count = 0;
  for (const std::size_t row : rows) {
    const std::string& shown = (*one.values)[row].shown;
    if (shown.empty() || count == maximumNamed) continue;
    ++count;
    name += (name.empty() ? "" : ", ") + named(row, shown);
  }
  return name.empty() ? one.stem : name;
}

void makeUnique(std::vector<std::string>& names) {
  std::set<std::string> taken;
  for (std::string& name : names) {
    const std::string plain = name;
    for (int number = 2; !taken.insert(name).second; ++number) name = plain + " (" + std::to_string(number) + ")";
  }
}

}  // namespace

ComparedCase comparedCase(const CaseDescription& description) {
  ComparedCase values;
  for (const auto& parameter : parameterTable()) values.push_back(comparedValue(description, parameter));
  values.resize(2 * parameterTable().size());
  if (description.extent == ModelExtent::half) return values;
  const auto right = rightOf(description);
  for (std::size_t left = 0; left < parameterTable().size(); ++left) {
    const auto& parameter = parameterTable()[left];
    if (!mayDiffer(parameter.key)) continue;
    auto value = comparedValue(right, parameter);
    if (value.identity != values[left].identity) values[parameterTable().size() + left] = std::move(value);
  }
  return values;
}

const Parameter& comparedParameter(std::size_t row) {
  return parameterTable()[isRowOfRight(row) ? row - parameterTable().size() : row];
}

std::string comparedKey(std::size_t row) {
  return (isRowOfRight(row) ? std::string(rightGroup) + "." : "") + comparedParameter(row).key;
}

std::string comparedLabel(std::size_t row) {
  return (isRowOfRight(row) ? "right " : "") + shortLabel(comparedParameter(row));
}

std::vector<std::size_t> differingRows(const std::vector<const ComparedCase*>& cases) {
  std::vector<std::size_t> rows;
  if (cases.empty()) return rows;
  for (std::size_t row = 0; row < cases[0]->size(); ++row)
    if (std::any_of(cases.begin(), cases.end(),
                    [&](const auto* each) { return (*each)[row].identity != (*cases[0])[row].identity; }))
      rows.push_back(row);
  std::stable_sort(rows.begin(), rows.end(), [](std::size_t a, std::size_t b) {
    return importance(comparedParameter(a)) < importance(comparedParameter(b));
  });
  return rows;
}

std::string printedWords(const std::string& key) {
  static const std::map<std::string, std::string> printed{{"beyond", "distance beyond"},
                                                          {"cwt_voices", "CWT voices"},
                                                          {"poisson_ratio", "Poisson's ratio"},
                                                          {"run_up", "run-up"},
                                                          {"selective_inertia", "selective mass scaling"},
                                                          {"young_modulus", "Young's modulus"}};
  if (const auto found = printed.find(key); found != printed.end()) return found->second;
  std::string words = key;
  std::replace_if(
      words.begin(), words.end(), [](char letter) { return letter == '.' || letter == '_'; }, ' ');
  return words;
}

std::string shortLabel(const Parameter& parameter) {
  const auto dot = parameter.key.find('.');
  if (dot == std::string::npos) return printedWords(parameter.key);
  const std::string own = printedWords(parameter.key.substr(dot + 1));
  const bool plain = parameter.group == "defect" || parameter.group == "motion" || parameter.group == "mesh";
  return plain ? own : printedWords(parameter.key.substr(0, dot)) + " " + own;
}

std::vector<std::string> caseNames(const std::vector<CaseToName>& cases) {
  std::map<std::string, std::vector<const ComparedCase*>> groups;
  for (const auto& one : cases) groups[one.stem].push_back(one.values);
  std::map<std::string, std::vector<std::size_t>> rows;
  for (const auto& [stem, values] : groups) rows[stem] = differingRows(values);
  std::vector<std::string> names;
  for (const auto& one : cases) names.push_back(suggestedName(one, rows[one.stem], groups.size() > 1));
  makeUnique(names);
  return names;
}

}  // namespace squat::cases
