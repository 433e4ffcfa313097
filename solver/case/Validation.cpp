#include "case/Validation.h"

#include <algorithm>

#include "case/Applicability.h"
#include "case/CaseRelations.h"
#include "case/ParameterValue.h"

namespace squat::cases {

std::vector<Finding> validateRelations(const CaseDescription& description) {
  std::vector<Finding> findings;
  relations::checkMaterials(description, findings);
  relations::checkWheelset(description, findings);
  relations::checkTrackAndRun(description, findings);
  relations::checkDefect(description, findings);
  relations::checkTread(description, findings);
  relations::checkIrregularity(description, findings);
  relations::checkLosses(description, findings);
  relations::checkSeat(description, findings);
  relations::checkMesh(description, findings);
  relations::checkTraction(description, findings);
  return findings;
}

Validation validate(const CaseDescription& description) {
  Validation result;
  std::vector<std::string> wrong;
  for (const auto& parameter : parameterTable())
    if (auto problem = checkRange(description, parameter)) {
      wrong.push_back(parameter.key);
      result.problems.push_back(std::move(*problem));
    }
  for (auto& finding : validateRelations(description)) {
    const bool amongWrong = std::any_of(finding.keys.begin(), finding.keys.end(), [&](const auto& key) {
      return std::find(wrong.begin(), wrong.end(), key) != wrong.end();
    });
    if (amongWrong) continue;
    auto& list = finding.severity == Severity::problem ? result.problems : result.warnings;
    list.push_back(std::move(finding.problem));
  }
  for (const auto& parameter : parameterTable())
    if (auto warning = valueWithoutEffect(description, parameter)) result.warnings.push_back(std::move(*warning));
  return result;
}

}  // namespace squat::cases
