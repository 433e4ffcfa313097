// solver/case/CaseDeclaration.h - the names of a case, for headers that only hand it on: CaseDescription.h brings all
// that is simulated with it.
#pragma once

namespace squat::cases {

struct CaseDescription;
struct ResolvedCase;

}  // namespace squat::cases
