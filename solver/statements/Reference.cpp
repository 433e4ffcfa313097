#include "statements/Reference.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ShippedCases.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "statements/Measures.h"

namespace squat::statements {

namespace {

using nlohmann::json;

constexpr int kVersion = 2;  // 2: expected with tolerance, trends, parameters, numbers, sensitivity

std::vector<std::pair<std::string, std::string>> setsFrom(const json& list) {
  std::vector<std::pair<std::string, std::string>> sets;
  for (const std::string set : list) {
    const auto split = set.find('=');
    if (split == std::string::npos) throw std::invalid_argument("'" + set + "' is not KEY=VALUE");
    sets.emplace_back(set.substr(0, split), set.substr(split + 1));
  }
  return sets;
}

ReferenceRun runFrom(const json& entry) {
  return {entry.at("name"), entry.at("case"), setsFrom(entry.at("set")),
          setsFrom(entry.value("set_on_paper", json::array()))};
}

void readRange(const json& entry, Statement& s) {
  if (entry.contains("expected")) s.expected = entry["expected"].get<double>();
  if (entry.contains("tolerance")) {
    const double width = std::abs(s.expected.value_or(NAN)) * entry["tolerance"].get<double>();
    if (!(width > 0)) throw std::invalid_argument("a tolerance needs an expected value other than zero");
    s.low = *s.expected - width;
    s.high = *s.expected + width;
  }
  if (entry.contains("low")) s.low = entry["low"];
  if (entry.contains("high")) s.high = entry["high"];
  if (std::isinf(s.low) && std::isinf(s.high))
    throw std::invalid_argument("has no range: needs low, high or tolerance");
  if (!(s.low < s.high)) throw std::invalid_argument("lower limit not below upper limit");
}

Statement statementFrom(const json& entry) {
  Statement s;
  s.section = entry.at("section");
  s.text = entry.at("statement");
  s.name = entry.value("name", s.text);
  s.run = entry.at("run");
  s.against = entry.value("against", "");
  s.measure = entry.at("measure");
  if (s.measure == "quiet") s.measure = "residual_vibration";  // its name until 0.2, in the files of users
  s.mesh = entry.value("mesh", "");
  s.point = entry.value("point", axleBox);
  if (s.point != axleBox && s.point != wheelCentre) throw std::invalid_argument("point '" + s.point + "' is unknown");
  if (entry.contains("band")) s.band = {entry["band"].at(0), entry["band"].at(1)};
  s.near = entry.value("near", 0.0);
  s.unit = entry.at("unit");
  s.reason = entry.at("reason");
  if (s.measure == "none") return s;
  readRange(entry, s);
  const auto known = measureNames();
  if (std::find(known.begin(), known.end(), s.measure) == known.end())
    throw std::invalid_argument("measure '" + s.measure + "' is unknown");
  const auto isOneOf = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), s.measure) != names.end();
  };
  if (isOneOf({"band_power", "band_share", "free_vibration", "lines_within"}) &&
      !(s.band.first >= 0 && s.band.second > s.band.first))
    throw std::invalid_argument("measure '" + s.measure + "' needs a band: [lower, upper]");
  if (s.measure == "line" && !(s.near > 0)) throw std::invalid_argument("measure 'line' needs a frequency near which");
  return s;
}

const std::string& knownKey(const std::string& key) {
  if (!cases::findParameter(key)) throw std::invalid_argument("key '" + key + "' is unknown");
  return key;
}

// Each entry of an array that may be missing, with its place for messages.
template <typename Take>
void forEach(const json& all, const char* array, const std::string& what, std::string& location, Take take) {
  if (!all.contains(array)) return;
  std::size_t number = 0;
  for (const auto& entry : all.at(array)) {
    location = what + " " + std::to_string(++number);
    take(entry);
  }
}

void readSensitivity(const json& all, Reference& reference, std::string& location) {
  if (!all.contains("sensitivity")) return;
  location = "sensitivity";
  reference.sensitivityRun = all["sensitivity"].at("run");
  if (!reference.run(reference.sensitivityRun))
    throw std::invalid_argument("run '" + reference.sensitivityRun + "' is not listed");
  forEach(all["sensitivity"], "keys", "sensitivity", location, [&](const json& entry) {
    SensitivityKey key{knownKey(entry.at("key")), entry.at("text"), entry.at("values")};
    if (key.values.empty()) throw std::invalid_argument("has no values");
    reference.sensitivity.push_back(std::move(key));
  });
}

// What the library says, without the name of its kind of error in front.
std::string wordsOf(const json::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

cases::CaseDescription ReferenceRun::caseOn(const std::string& mesh) const {
  cases::CaseOverrides overrides{mesh, sets};
  if (mesh == "paper") overrides.values.insert(overrides.values.end(), paperSets.begin(), paperSets.end());
  return cases::loadCase(caseName, overrides);
}

const ReferenceRun* Reference::run(const std::string& name) const {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const auto& run) { return run.name == name; });
  return found == runs.end() ? nullptr : &*found;
}

Reference readReference(const std::string& path) {
  constexpr std::size_t largest = 10000000;
  return parseReference(readWholeFile(path, largest), path);
}

Reference parseReference(std::string_view text, const std::string& path) {
  std::string location;
  try {
    const auto all = json::parse(text);
    if (all.at("schema") != "squat-reference") throw std::invalid_argument("is not a reference file of this program");
    if (all.at("schema_version") > kVersion)
      throw std::invalid_argument("was written for a newer version; install the newer program");
    Reference reference;
    reference.source = all.at("source");
    if (all.at("runs").empty()) throw std::invalid_argument("lists no run");
    forEach(all, "runs", "run", location, [&](const json& entry) { reference.runs.push_back(runFrom(entry)); });
    if (all.at("statements").empty()) throw std::invalid_argument("lists no statement");
    forEach(all, "statements", "statement", location, [&](const json& entry) {
      auto statement = statementFrom(entry);
      for (const auto& name : {statement.run, statement.against})
        if (!name.empty() && !reference.run(name)) throw std::invalid_argument("run '" + name + "' is not listed");
      reference.statements.push_back(std::move(statement));
    });
    forEach(all, "parameters", "parameter", location, [&](const json& entry) {
      reference.parameters.push_back(
          {entry.at("section"), entry.at("statement"), knownKey(entry.at("key")), entry.at("value")});
    });
    forEach(all, "numbers", "number", location, [&](const json& entry) {
      reference.numbers.push_back({entry.at("section"), entry.at("statement"), entry.at("value"), entry.at("unit")});
    });
    readSensitivity(all, reference, location);
    return reference;
  } catch (const json::exception& error) {
    throw FileError(path, location, wordsOf(error), "Compare with resources/reference/paper.json (schema 2)");
  } catch (const std::invalid_argument& error) {
    throw FileError(path, location, error.what());
  }
}

std::string paperReferencePath() { return (cases::resourcesFolder() / "reference/paper.json").string(); }

}  // namespace squat::statements
