#include "results/RunResult.h"

#include "case/Resolve.h"
#include "core/Errors.h"

namespace squat::results {

void setCase(RunResult& result, const cases::CaseDescription& description) {
  result.caseToml = cases::writeCase(description);
  result.caseHash = cases::caseHash(description);
  result.resolvedCase =
      std::make_shared<const cases::ResolvedCase>(cases::ResolvedCase{description, cases::resolve(description)});
  result.caseProblem.clear();
}

void readCaseOf(RunResult& result) {
  result.resolvedCase.reset();
  result.caseProblem.clear();
  if (result.caseToml.empty()) return;
  try {
    const auto description = cases::parseCaseOfResult(result.caseToml, "case of the result");
    result.resolvedCase =
        std::make_shared<const cases::ResolvedCase>(cases::ResolvedCase{description, cases::resolve(description)});
  } catch (const CaseError& error) {
    result.caseProblem = error.what();
  } catch (const FileError& error) {
    result.caseProblem = error.what();
  }
}

const cases::ResolvedCase& caseOf(const RunResult& result) {
  if (result.resolvedCase) return *result.resolvedCase;
  throw FileError(result.stem, "case_toml",
                  result.caseToml.empty() ? "is missing" : "cannot be read by this version: " + result.caseProblem,
                  "Run the case again with this version");
}

}  // namespace squat::results
