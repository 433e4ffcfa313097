// solver/case/Resolve.h - from what a user wrote to what is simulated.
#pragma once

#include <optional>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"

namespace squat::cases {

// The scenario of a case that has been validated (Validation.h): everything in SI, the surface of its defect made.
scenario::Scenario resolve(const CaseDescription& description);

// Both sides of a whole model, on meshes for what either of them has in its way; of a half model the one there is.
struct Sides {
  scenario::Scenario left;
  std::optional<scenario::Scenario> right;
};
Sides resolveSides(const CaseDescription& description);

// The surface of the defect that the case describes: of a profile with its height scale. The one way from a case to a
// surface, for all who ask about a case that is not run yet.
scenario::DefectSurface surfaceOf(const CaseDescription& description);
// The same of the wheel's tread.
scenario::TreadDeviation treadOf(const CaseDescription& description);

// The irregularity of its rail, and the levels that it is made from where it is random.
IrregularSurface irregularityOf(const CaseDescription& description);
std::vector<WavelengthLevel> levelsOf(const Irregularity& rail);

// The finely meshed stretch of rail that its defect needs.
DefectZone defectZone(const CaseDescription& description);

// A case and what it is resolved into: made once, carried by a result.
struct ResolvedCase {
  CaseDescription description;
  scenario::Scenario scenario;
};

// loadCase(), resolved.
scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides = {});

}  // namespace squat::cases
