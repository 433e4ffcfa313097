#include "validation/Reference.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "validation/Measures.h"

namespace squat::validation {

namespace {

using nlohmann::json;

constexpr int kVersion = 1;

ReferenceRun runFrom(const json& entry) {
  ReferenceRun run{entry.at("name"), entry.at("case"), {}};
  for (const std::string set : entry.at("set")) {
    const auto split = set.find('=');
    if (split == std::string::npos) throw std::invalid_argument("'" + set + "' is no KEY=VALUE");
    run.sets.emplace_back(set.substr(0, split), set.substr(split + 1));
  }
  return run;
}

Statement statementFrom(const json& entry) {
  Statement s;
  s.section = entry.at("section");
  s.text = entry.at("statement");
  s.run = entry.at("run");
  s.against = entry.value("against", "");
  s.measure = entry.at("measure");
  s.mesh = entry.value("mesh", "");
  if (entry.contains("band")) s.band = {entry["band"].at(0), entry["band"].at(1)};
  s.near = entry.value("near", 0.0);
  s.unit = entry.at("unit");
  s.reason = entry.at("reason");
  if (s.measure == "none") return s;
  s.low = entry.at("low");
  s.high = entry.at("high");
  if (!(s.low < s.high)) throw std::invalid_argument("its range is upside down");
  const auto known = measureNames();
  if (std::find(known.begin(), known.end(), s.measure) == known.end())
    throw std::invalid_argument("measure '" + s.measure + "' is not known");
  return s;
}

}  // namespace

Reference readReference(const std::string& path) {
  constexpr std::size_t largest = 10000000;
  const auto text = readWholeFile(path, largest);
  std::string place;
  try {
    const auto all = json::parse(text);
    if (all.at("schema") != "squat-reference") throw std::invalid_argument("is no reference of this program");
    if (all.at("schema_version") > kVersion)
      throw std::invalid_argument("is of a newer version; install the newer program");
    Reference reference;
    reference.source = all.at("source");
    for (const auto& entry : all.at("runs")) {
      place = "run " + std::to_string(reference.runs.size() + 1);
      reference.runs.push_back(runFrom(entry));
    }
    const auto isRun = [&](const std::string& name) {
      return std::any_of(reference.runs.begin(), reference.runs.end(),
                         [&](const auto& run) { return run.name == name; });
    };
    for (const auto& entry : all.at("statements")) {
      place = "statement " + std::to_string(reference.statements.size() + 1);
      auto statement = statementFrom(entry);
      for (const auto& name : {statement.run, statement.against})
        if (!name.empty() && !isRun(name)) throw std::invalid_argument("run '" + name + "' is not listed");
      reference.statements.push_back(std::move(statement));
    }
    return reference;
  } catch (const json::exception& error) {
    throw FileError(path, place, error.what());
  } catch (const std::invalid_argument& error) {
    throw FileError(path, place, error.what());
  }
}

}  // namespace squat::validation
