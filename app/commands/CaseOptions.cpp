#include "commands/CaseOptions.h"

#include <algorithm>
#include <cstdio>

#include "case/Applicability.h"
#include "case/CaseDescription.h"
#include "case/RightSide.h"
#include "case/ShippedCases.h"
#include "core/Errors.h"
#include "text/Text.h"

namespace squat::commands {

namespace {

std::string shippedNames() {
  std::string text;
  for (const auto& name : cases::shippedCases()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void addCaseOptions(CLI::App& command, CaseOptions& options) {
  addCaseWithoutMesh(command, options);
  command.add_option("--mesh", options.mesh, "Mesh preset: tiny, draft, standard or paper")->type_name("PRESET");
}

void addCaseWithoutMesh(CLI::App& command, CaseOptions& options, const std::string& name) {
  command.add_option(name, options.name, "Case file (TOML), or a shipped case: " + shippedNames())
      ->required()
      ->type_name("CASE");
  command
      .add_option("--set", options.sets,
                  "Set one key of the case, in the unit of the case file or with a unit (motion.speed=\"108 km/h\"); "
                  "repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

namespace {

// A name must stay one in every folder that it is put into, and be seen there.
std::string refusalOfName(std::string& name) {
  constexpr std::size_t longest = 200;  // file systems take 255 bytes, with the endings
  const bool isPlain = std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; });
  if (!name.empty() && name.size() <= longest && isPlain && name.find_first_of("/\\") == std::string::npos &&
      name.front() != '.' && name.front() != '-')
    return {};
  return "is " + text::shown(name) +
         ", must be a name of 1 to 200 bytes without slashes that begins with neither a point nor a hyphen; folders "
         "are chosen with -o";
}

}  // namespace

void addName(CLI::App& command, CaseOptions& options, const std::string& help) {
  command.add_option("--name", options.stem, help)->check(CLI::Validator(refusalOfName, ""))->type_name("NAME");
}

std::string stemOf(const CaseOptions& options) {
  return options.stem.empty() ? cases::caseStem(options.name) : options.stem;
}

namespace {

// A key that is set twice has one value that its user did not mean.
void checkOnce(const cases::CaseOverrides& overrides, const std::string& key, const std::string& value,
               std::vector<CaseProblem>& problems) {
  const auto refuse = [&](const std::string& other) {
    problems.push_back({"--set " + key + "=" + value, "", "", "already set by " + other + "; remove one of them"});
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
      problems.push_back({"--set", set, "KEY=VALUE", "Example: --set motion.speed=30"});
    else {
      checkOnce(overrides, set.substr(0, split), set.substr(split + 1), problems);
      overrides.values.emplace_back(set.substr(0, split), set.substr(split + 1));
    }
  }
  return problems;
}

// Validation warns of a value that has no effect where it differs from the default; a key that is typed and has no
// effect is worth a warning even where it does not.
void reportUselessSets(const cases::CaseDescription& description, const cases::CaseOverrides& overrides) {
  for (const auto& [key, value] : overrides.values) {
    const auto& parameter = *cases::findOnEitherSide(key);
    const auto side = cases::sideOf(description, key);
    if (!cases::applies(side, parameter) && !cases::valueWithoutEffect(side, parameter))
      std::fprintf(stderr, "warning: --set %s=%s: %s\n", key.c_str(), value.c_str(),
                   cases::reasonWithoutEffect(side, parameter).c_str());
  }
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
  if (problems.empty()) {
    auto description = cases::loadCase(options.name, overrides);
    reportUselessSets(description, overrides);
    return description;
  }
  try {
    cases::loadCase(options.name, overrides);
  } catch (const CaseError& others) {  // all errors are reported together
    problems.insert(problems.end(), others.problems().begin(), others.problems().end());
  }
  throw CaseError(problems);
}

}  // namespace squat::commands
