#include "statements/PaperCase.h"

#include <algorithm>
#include <array>

#include "case/CaseFile.h"
#include "case/InputPresets.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "case/RightSide.h"
#include "case/ShippedCases.h"
#include "core/Errors.h"

namespace squat::statements {

namespace {

constexpr std::array<const char*, 4> kPaperCases{"light-defect", "class-c-squat", "class-c-squat-modified",
                                                 "smooth-rail"};

bool counts(const cases::Parameter& parameter) {
  // The mesh presets themselves set these three; the path of a profile is a name, its points are compared. So are the
  // values of other presets.
  static const std::array<const char*, 6> free{"track.length",      "motion.run_up",    "motion.beyond",
                                               "output.cwt_voices", "output.time_step", "defect.file"};
  return parameter.group != "case" && parameter.group != "mesh" && !cases::isInputPreset(parameter.key) &&
         std::find(free.begin(), free.end(), parameter.key) == free.end();
}

// A list of points is too long to be shown.
std::string shown(const cases::CaseDescription& description, const cases::Parameter& parameter) {
  if (cases::isList(parameter)) return "another profile";
  const bool bare = parameter.unit.empty() || parameter.unit == "-";
  return cases::valueText(description, parameter) + (bare ? "" : " " + parameter.unit);
}

// The cases stay within adhesion; the paper's runs, as `squat validate` makes them, have the paper's torque.
bool isThePapersTorque(const std::string& key, const std::string& value) {
  return key == "motion.torque" && value == "12450.49";
}

void addDifference(const cases::Parameter& parameter, const std::string& key, const cases::CaseDescription& ours,
                   const cases::CaseDescription& paper, std::vector<ChangedKey>& changed) {
  const auto own = cases::valueText(ours, parameter);
  if (!counts(parameter) || own == cases::valueText(paper, parameter) || isThePapersTorque(key, own)) return;
  changed.push_back({key, shown(ours, parameter), cases::isList(parameter) ? "its own" : shown(paper, parameter)});
}

// Both rails of the paper's cases are alike: the right side of a whole model has the same counterpart as the left one.
std::vector<ChangedKey> differences(const cases::CaseDescription& ours, const cases::CaseDescription& paper) {
  std::vector<ChangedKey> changed;
  for (const auto& parameter : cases::parameterTable()) addDifference(parameter, parameter.key, ours, paper, changed);
  if (ours.extent != cases::ModelExtent::whole) return changed;
  const auto right = cases::rightOf(ours);
  for (const auto& [key, text] : ours.right)
    addDifference(*cases::findParameter(key), std::string(cases::rightGroup) + "." + key, right, paper, changed);
  return changed;
}

bool isDefect(const ChangedKey& changed) { return changed.key.rfind("defect.", 0) == 0; }

}  // namespace

std::optional<PaperCase> paperCaseOf(const results::RunResult& result) {
  if (!result.resolvedCase) return std::nullopt;
  std::optional<PaperCase> nearest;
  try {
    const auto& ours = result.resolvedCase->description;
    cases::CaseOverrides overrides;
    overrides.preset = meshPresetOf(result);
    for (const char* name : kPaperCases) {
      auto changed = differences(ours, cases::loadCase(name, overrides));
      if (!nearest || changed.size() < nearest->changed.size()) nearest = PaperCase{name, std::move(changed)};
    }
  } catch (const CaseError&) {  // a case that this version cannot read is none of the paper's
    return std::nullopt;
  } catch (const FileError&) {  // the shipped cases are not installed
    return std::nullopt;
  }
  if (std::any_of(nearest->changed.begin(), nearest->changed.end(), isDefect)) return std::nullopt;
  return nearest;
}

std::string meshPresetOf(const results::RunResult& result) {
  return cases::valueText(results::caseOf(result).description, *cases::findParameter("mesh.preset"));
}

}  // namespace squat::statements
