// solver/case/ParameterLevels.h - who sets which key.
#pragma once

#include <string_view>
#include <vector>

#include "case/ParameterTable.h"

namespace squat::cases {

// The keys of a level that is not advanced; advanced is what no list names.
const std::vector<std::string_view>& keysOfLevel(Level level);

// A key that no list names is advanced.
Level levelOf(std::string_view key);

}  // namespace squat::cases
