// solver/case/MeshPresets.h - what mesh.preset sets: one small table, one code path for all meshes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

struct PresetRow {
  std::string key;
  std::array<const char*, 4> values;  // tiny, draft, standard, paper: text in the unit of the case file
};
const std::vector<PresetRow>& presetTable();

std::optional<MeshPreset> presetNamed(std::string_view name);  // empty: no such name

// Sets mesh.preset and all keys of the table; keys that the user stated are set after this.
void applyPreset(CaseDescription& description, MeshPreset preset);

// Where the preset rolls a shorter stretch than the default mesh does: one sentence with the values; else empty.
std::string presetNote(const CaseDescription& description);

}  // namespace squat::cases
