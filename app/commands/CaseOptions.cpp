#include "commands/CaseOptions.h"

#include "case/ShippedCases.h"
#include "core/Errors.h"

namespace squat::commands {

namespace {

std::string shippedNames() {
  std::string text;
  for (const auto& name : cases::shippedCases()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void addCaseOptions(CLI::App& command, CaseOptions& options) {
  command.add_option("case", options.name, "Case file (TOML), or a shipped case: " + shippedNames())
      ->required()
      ->type_name("CASE");
  command.add_option("--mesh", options.mesh, "Mesh preset: tiny, draft, standard or paper")->type_name("PRESET");
  command
      .add_option("--set", options.sets, "Changes one key of the case, in the unit of the case file; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

namespace {

// A key that is set twice has one value that its user did not mean.
void checkOnce(const cases::CaseOverrides& overrides, const std::string& key, const std::string& value,
               std::vector<CaseProblem>& problems) {
  const auto refuse = [&](const std::string& other) {
    problems.push_back({"--set", key + "=" + value, "each key once", "It is set by " + other + " too: leave one out"});
  };
  for (const auto& [name, text] : overrides.values)
    if (name == key) return refuse("--set " + name + "=" + text);
  if (key == "mesh.preset" && !overrides.preset.empty()) refuse("--mesh " + overrides.preset);
}

// Takes what is well formed into `overrides`; returns the rest.
std::vector<CaseProblem> takeSets(const CaseOptions& options, cases::CaseOverrides& overrides) {
  overrides.preset = options.mesh;
  std::vector<CaseProblem> problems;
  for (const auto& set : options.sets) {
    const auto split = set.find('=');
    if (split == std::string::npos || split == 0)
      problems.push_back({"--set", set, "KEY=VALUE", "Write for example --set motion.speed=30"});
    else {
      checkOnce(overrides, set.substr(0, split), set.substr(split + 1), problems);
      overrides.values.emplace_back(set.substr(0, split), set.substr(split + 1));
    }
  }
  return problems;
}

}  // namespace

cases::CaseOverrides caseOverrides(const CaseOptions& options) {
  cases::CaseOverrides overrides;
  const auto problems = takeSets(options, overrides);
  if (!problems.empty()) throw CaseError(problems);
  return overrides;
}

cases::CaseDescription readCase(const CaseOptions& options) {
  cases::CaseOverrides overrides;
  auto problems = takeSets(options, overrides);
  if (problems.empty()) return cases::loadCase(options.name, overrides);
  try {
    cases::loadCase(options.name, overrides);
  } catch (const CaseError& others) {  // all mistakes at once
    problems.insert(problems.end(), others.problems().begin(), others.problems().end());
  }
  throw CaseError(problems);
}

}  // namespace squat::commands
