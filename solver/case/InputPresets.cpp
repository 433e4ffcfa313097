#include "case/InputPresets.h"

#include <algorithm>

#include "case/CaseStatements.h"
#include "case/ParameterValue.h"
#include "case/ShippedCases.h"
#include "core/DurableFile.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestPreset = 100'000;  // bytes

// wheelset.preset: resources/presets/wheelset
std::filesystem::path fileOf(std::string_view key, const std::string& name) {
  return resourcesFolder() / "presets" / std::string(key.substr(0, key.find('.'))) / (name + ".toml");
}

// Checked here, so that whoever applies a preset has nothing to report.
void requireGood(const Stated& one, const std::string& origin) {
  CaseDescription trial;
  auto wrong = one.typeProblem;
  if (!wrong && isInputPreset(one.key)) wrong = CaseProblem{one.key, one.text, "no preset", "A preset names no other"};
  if (!wrong) wrong = trySetValue(trial, *findParameter(one.key), one.text);
  if (wrong) throw FileError(origin, "line " + std::to_string(one.line), toText(*wrong), "Install the program again");
}

}  // namespace

bool isInputPreset(std::string_view key) {
  return std::find(std::begin(inputPresetKeys), std::end(inputPresetKeys), key) != std::end(inputPresetKeys);
}

const std::vector<std::string>& inputPresetNames(std::string_view key) {
  static const std::vector<std::string> wheelset{noPreset, "estimated", "trailer"};
  static const std::vector<std::string> track{noPreset, "estimated", "stiff-pads", "soft-pads"};
  static const std::vector<std::string> rail{noPreset, "R260", "R350HT"};
  return key == "track.preset" ? track : key == "rail.preset" ? rail : wheelset;
}

PresetValues inputPresetValues(std::string_view key, const std::string& name) {
  const auto& names = inputPresetNames(key);
  if (name == noPreset || std::find(names.begin(), names.end(), name) == names.end()) return {};
  const std::string origin = fileOf(key, name).string(), text = readWholeFile(origin, largestPreset);
  PresetValues values;
  for (const auto& one : statementsOf(parsedToml(text, origin), text)) {
    requireGood(one, origin);
    values.emplace_back(one.key, one.text);
  }
  return values;
}

void applyInputPreset(CaseDescription& description, std::string_view key, const std::string& name) {
  for (const auto& [own, text] : inputPresetValues(key, name)) setValue(description, own, text);
  setValue(description, key, name);
}

}  // namespace squat::cases
