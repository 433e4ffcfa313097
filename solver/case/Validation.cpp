#include "case/Validation.h"

#include <algorithm>

#include "case/Applicability.h"
#include "case/CaseRelations.h"
#include "case/Findings.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "scenario/WheelsetMass.h"

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
  relations::checkBogie(description, findings);
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

// A wheelset carried at its journals and standing on its wheels: half of the difference of the loads, times the ratio
// of the levers, is added on one side and taken off on the other.
void checkBothWheelsStand(const CaseDescription& left, const CaseDescription& right, std::vector<Finding>& findings) {
  const auto& w = left.wheelset;
  const double lever = (w.trackCentre + w.bearingCentre) / w.trackCentre, own = scenario::wheelsetMass(w);
  const double onLeft = left.suspension.sprungMass, onRight = right.suspension.sprungMass;
  const double light = std::min(onLeft, onRight), heavy = std::max(onLeft, onRight);
  const double standing = own + 0.5 * (light + heavy) - 0.5 * lever * (heavy - light);  // [kg] on the light side
  constexpr double least = 0.02;  // of the mean: closer than that, rounding and deflections decide
  if (standing > least * (own + 0.5 * (light + heavy))) return;
  const double needed = (heavy * (lever - 1 + least) - 2 * (1 - least) * own) / (1 + lever - least);
  const std::string key = "suspension.sprung_mass";
  const bool isRight = onRight < onLeft;
  CaseProblem problem{key, relations::rounded(light) + " kg",
                      "at least " + relations::rounded(1.01 * needed, relations::Side::above) + " kg",
                      std::string("The ") + (isRight ? "right" : "left") +
                          " wheel lifts: the load on the other side, " + relations::rounded(heavy) +
                          " kg, tips the wheelset over its wheel"};
  findings.push_back({Severity::problem, isRight ? cases::onRight(std::move(problem)) : std::move(problem), {key}});
}

}  // namespace

std::vector<Finding> validateRelations(const CaseDescription& description) {
  auto findings = validateSide(description);
  if (description.extent == ModelExtent::half) return findings;
  if (!description.right.empty()) addRightSide(description, findings);
  checkBothWheelsStand(description, rightOf(description), findings);
  if (description.wheelset.bearingStiffness > 0)
    relations::add(
        findings, description, Severity::warning, {"wheelset.bearing_stiffness", "model.extent"},
        "0 for lateral signals",
        "A box on a spring has no mass along the axle: aba_lateral and the wheelset's lateral motion are those "
        "of a wheelset without boxes");
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
