// solver/case/InputPresets.h - wheelset.preset, track.preset and rail.preset: names of sets of values for other keys.
//
// The values of a name stand in resources/presets/wheelset/NAME.toml, presets/track or presets/rail, which are parts of
// a case, each value with its source beside it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

inline constexpr const char* noPreset = "none";  // sets nothing
inline constexpr const char* inputPresetKeys[] = {"wheelset.preset", "track.preset", "rail.preset"};

bool isInputPreset(std::string_view key);

// Names that such a key may take, "none" first.
const std::vector<std::string>& inputPresetNames(std::string_view key);

// What a name sets: keys, and values in the unit of the case file. Empty for "none" and for an unknown name. Throws
// FileError where the file is missing or no preset.
using PresetValues = std::vector<std::pair<std::string, std::string>>;
PresetValues inputPresetValues(std::string_view key, const std::string& name);

// Sets the key itself and all that the name sets; keys that the user stated are set after this.
void applyInputPreset(CaseDescription& description, std::string_view key, const std::string& name);

}  // namespace squat::cases
