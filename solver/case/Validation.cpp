#include "case/Validation.h"

#include <algorithm>

#include "case/Applicability.h"
#include "case/CaseRelations.h"
#include "case/Findings.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"

namespace squat::cases {

namespace {

std::vector<Finding> validateSide(const CaseDescription& description) {
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

// What is wrong with the right side and is not with the left.
void addRightSide(const CaseDescription& description, std::vector<Finding>& findings) {
  auto ofRight = validateSide(rightOf(description));
  std::erase_if(ofRight, [&](const Finding& one) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& left) {
      return left.problem.key == one.problem.key && left.problem.value == one.problem.value &&
             left.problem.allowed == one.problem.allowed;
    });
  });
  for (auto& finding : ofRight) {
    const auto isStated = [&](const auto& one) { return one.first == finding.problem.key; };
    if (std::any_of(description.right.begin(), description.right.end(), isStated))
      finding.problem = onRight(finding.problem);
    else
      finding.problem.advice = "Because of the right side: " + finding.problem.advice;
    findings.push_back(std::move(finding));
  }
}

}  // namespace

std::vector<Finding> validateRelations(const CaseDescription& description) {
  auto findings = validateSide(description);
  if (description.extent == ModelExtent::half) return findings;
  if (!description.right.empty()) addRightSide(description, findings);
  const auto& rail = description.rail.irregularity;
  if (rail.kind != IrregularityKind::none && rightOf(description).rail.irregularity.seed == rail.seed)
    relations::add(findings, description, Severity::warning, {"rail.irregularity", "model.extent"},
                   rail.kind == IrregularityKind::heights ? "none, or heights that both rails have"
                                                          : "another right.rail.irregularity_seed",
                   "Both rails have the same irregularity, as mirror images");
  if (description.rail.plastic)
    relations::add(findings, description, Severity::problem, {"rail.plastic", "model.extent"},
                   "false if model.extent is whole", "A whole model has an elastic rail: set one of them back");
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
  for (const auto& [key, text] : description.right)
    if (const auto reason = reasonWithoutRight(description, *findParameter(key)); !reason.empty())
      result.warnings.push_back(onRight({key, text, "", reason}));
  return result;
}

}  // namespace squat::cases
