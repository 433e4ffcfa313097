#include "calibration/CalibratedCase.h"

#include "case/CaseDescription.h"
#include "case/ParameterValue.h"

namespace squat::calibration {

namespace {

// Behind the comment of the line that sets the key: "pad.stiffness" stands as "stiffness = ..." in the table "[pad]".
void mark(std::string& text, const std::string& key, const std::string& remark) {
  const auto dot = key.rfind('.');
  const auto table = text.find("\n[" + key.substr(0, dot) + "]\n");
  const auto line = text.find("\n" + key.substr(dot + 1) + " = ", table == std::string::npos ? 0 : table);
  if (line == std::string::npos) return;
  text.insert(text.find('\n', line + 1), remark);
}

}  // namespace

std::string calibratedCase(const Calibration& calibration) {
  const auto& definition = calibration.definition;
  auto overrides = definition.overrides;
  const auto& best = calibration.evaluations[calibration.best];
  for (std::size_t i = 0; i < definition.inputs.size(); ++i)
    overrides.values.emplace_back(definition.inputs[i].key(), valueText(best.values[i]));
  auto description = cases::loadCase(definition.caseName, overrides);
  description.note = "Calibrated against " + definition.targets.path +
                     (description.note.empty() ? "" : ". Before: " + description.note);
  auto text = cases::writeCase(description);
  for (std::size_t i = 0; i < definition.inputs.size(); ++i) {
    const auto& range = calibration.ranges[i];
    mark(text, definition.inputs[i].key(),
         "; estimated: " + valueText(range.low) + " to " + valueText(range.high) +
             " reproduce the targets equally well");
  }
  return text;
}

}  // namespace squat::calibration
