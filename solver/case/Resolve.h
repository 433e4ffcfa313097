// solver/case/Resolve.h - from what a user wrote to what is simulated.
#pragma once

#include "case/CaseDescription.h"
#include "case/CaseFile.h"

namespace squat::cases {

// The scenario of a case that has been validated (Validation.h): everything in SI, the surface of its defect made.
scenario::Scenario resolve(const CaseDescription& description);

// A case and what it is resolved into: made once, carried by a result.
struct ResolvedCase {
  CaseDescription description;
  scenario::Scenario scenario;
};

// loadCase(), resolved.
scenario::Scenario loadScenario(const std::string& nameOrPath, const CaseOverrides& overrides = {});

}  // namespace squat::cases
