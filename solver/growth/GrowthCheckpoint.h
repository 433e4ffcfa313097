// solver/growth/GrowthCheckpoint.h - a growing rail on disk, to resume from after a kill.
#pragma once

#include <optional>
#include <string>

#include "case/CaseDescription.h"
#include "growth/Grow.h"

namespace squat::growth {

// Replaces what stands under `path` whole or not at all.
void writeGrowth(const std::string& path, const cases::CaseDescription& description, const GrowthOptions& options,
                 const GrowthState& rail);
// Nothing where none stands there. Throws CaseError where it belongs to another case or to other grindings.
std::optional<GrowthState> readGrowth(const std::string& path, const cases::CaseDescription& description,
                                      const GrowthOptions& options);

}  // namespace squat::growth
