#include "case/MeshPresets.h"

#include <algorithm>

#include "case/ParameterValue.h"

namespace squat::cases {

const std::vector<PresetRow>& presetTable() {
  // clang-format off
  static const std::vector<PresetRow> table = {
      // key                   tiny   draft   standard  paper
      {"track.length", {"3", "10", "10", "10"}},
      {"motion.run_up", {"0.1", "0.3", "0.5", "1"}},
      {"motion.beyond", {"0.12", "0.3", "0.3", "0.3"}},
      {"mesh.contact_size", {"5", "2.6", "1.3", "1.3"}},
      {"mesh.rolling_size", {"10", "5", "2.6", "5"}},
      {"mesh.far_size", {"300", "75", "75", "75"}},
      {"mesh.section_size", {"24", "16", "10", "10"}},
      {"mesh.section_growth", {"1.7", "1.5", "1.33", "1.33"}},
      {"mesh.band_half_width", {"10", "7.8", "7.8", "7.8"}},
      {"mesh.coarse_web", {"false", "false", "true", "false"}},
      {"mesh.fine_before", {"6", "20", "20", "20"}},
      {"mesh.fine_start", {"15", "12", "20", "20"}},
      {"mesh.wheel_sectors", {"24", "48", "64", "96"}},
      {"mesh.rim_depth", {"20", "25", "25", "25"}},
  };
  // clang-format on
  return table;
}

std::optional<MeshPreset> presetNamed(std::string_view name) {
  const auto& names = findParameter("mesh.preset")->choices;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<MeshPreset>(found - names.begin());
}

void applyPreset(CaseDescription& description, MeshPreset preset) {
  description.mesh.preset = preset;
  for (const auto& row : presetTable()) setValue(description, row.key, row.values[static_cast<std::size_t>(preset)]);
}

std::string presetNote(const CaseDescription& description) {
  const auto preset = static_cast<std::size_t>(description.mesh.preset);
  std::string shortened;
  for (const auto& row : presetTable()) {
    if (row.key != "track.length" && row.key != "motion.run_up" && row.key != "motion.beyond") continue;
    const Parameter& parameter = *findParameter(row.key);
    const double value = numberInUnit(description, parameter);
    const bool ownValue = valueText(description, parameter) != row.values[preset];
    if (ownValue || !(value < std::stod(parameter.defaultText))) continue;
    shortened += (shortened.empty() ? "" : ", ") + row.key + " = " + row.values[preset] + " " + parameter.unit +
                 " (default " + parameter.defaultText + " " + parameter.unit + ")";
  }
  if (shortened.empty()) return {};
  return "mesh preset " + findParameter("mesh.preset")->choices[preset] +
         " shortens track and run, which are then computed sooner: " + shortened +
         "; values stated in the case are kept";
}

}  // namespace squat::cases
