// Keys that have an effect only with certain values of other keys: what each row declares, held against the shape that
// the wheel rolls over and against validation.
#include "case/Applicability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"
#include "case/Validation.h"
#include "scenario/DefectSurface.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;

std::vector<const Parameter*> conditional() {
  std::vector<const Parameter*> rows;
  for (const auto& parameter : parameterTable())
    if (!parameter.condition.empty()) rows.push_back(&parameter);
  return rows;
}

// A value of the key that is none of these.
std::string otherThan(const Parameter& parameter, const std::vector<std::string>& values) {
  const auto allowed = [&](const std::string& text) {
    return std::find(values.begin(), values.end(), text) == values.end();
  };
  std::vector<std::string> candidates;
  if (parameter.kind == Kind::choice) candidates = parameter.choices;
  if (parameter.kind == Kind::boolean) candidates = {"true", "false"};
  if (parameter.kind == Kind::number)
    candidates = {formatDecimal(parameter.maximum), formatDecimal(parameter.minimum), parameter.defaultText};
  if (parameter.kind == Kind::text) candidates = {"other.csv", ""};
  if (parameter.kind == Kind::points) candidates = {"[[0, 0], [5, -0.1], [10, 0]]", "[]"};
  if (parameter.kind == Kind::lines)
    candidates = {"[[-5, [[0, 0], [5, -0.1], [10, 0]]], [5, [[0, 0], [5, -0.2], [10, 0]]]]", "[]"};
  return *std::find_if(candidates.begin(), candidates.end(), allowed);
}

void satisfy(CaseDescription& description, const Requirement& requirement, bool met) {
  const Parameter& parameter = *findParameter(requirement.key);
  // A key that decides must have an effect itself, by another alternative than the first where that is its own.
  if (!parameter.condition.empty())
    for (const auto& deeper : parameter.condition.front()) satisfy(description, deeper, true);
  const bool isOneOf = requirement.relation == Requirement::Relation::isOneOf;
  setValue(description, parameter.key,
           isOneOf == met ? requirement.values.front() : otherThan(parameter, requirement.values));
}

CaseDescription where(const Parameter& parameter, const std::vector<Requirement>& alternative) {
  CaseDescription description = defaultCase();
  for (const auto& requirement : alternative) satisfy(description, requirement, true);
  EXPECT_TRUE(applies(description, parameter)) << parameter.key;
  return description;
}

bool warnsOf(const CaseDescription& description, const std::string& key) {
  const auto warnings = validate(description).warnings;
  return std::any_of(warnings.begin(), warnings.end(), [&](const auto& warning) {
    return warning.key == key && warning.advice.find("no effect") != std::string::npos;
  });
}

TEST(Applicability, EveryConditionNamesKnownKeysAndValues) {
  ASSERT_GE(conditional().size(), 20u);
  for (const auto* parameter : conditional())
    for (const auto& alternative : parameter->condition)
      for (const auto& requirement : alternative) {
        const Parameter* deciding = findParameter(requirement.key);
        ASSERT_TRUE(deciding) << parameter->key << ": " << requirement.key;
        ASSERT_FALSE(requirement.values.empty()) << parameter->key;
        for (const auto& value : requirement.values) {
          CaseDescription description = defaultCase();
          EXPECT_EQ(trySetValue(description, *deciding, value), std::nullopt) << parameter->key << ": " << value;
        }
        EXPECT_THAT(parameter->doc, HasSubstr(requirement.key));
      }
}

TEST(Applicability, EveryKeyWithoutEffectBringsAWarningThatNamesTheKeyThatDecides) {
  for (const auto* parameter : conditional())
    for (const auto& alternative : parameter->condition) {
      CaseDescription description = where(*parameter, alternative);
      const auto value = otherThan(*parameter, {isList(*parameter) ? "[]" : parameter->defaultText});
      setValue(description, parameter->key, value);
      EXPECT_FALSE(warnsOf(description, parameter->key)) << parameter->key << " = " << value;
      for (const auto& requirement : alternative) {
        CaseDescription without = description;
        satisfy(without, requirement, false);
        if (applies(without, *parameter)) continue;  // by another alternative
        EXPECT_TRUE(warnsOf(without, parameter->key)) << parameter->key << " against " << requirement.key;
        // Of several alternatives the first is named as the reason; all of them stand behind "applies if".
        const std::string because = parameter->condition.size() == 1 ? "because " : "";
        EXPECT_THAT(reasonWithoutEffect(without, *parameter), HasSubstr(because + requirement.key)) << parameter->key;
        setToDefault(without, *parameter);
        EXPECT_FALSE(warnsOf(without, parameter->key)) << parameter->key << ": every written case states it";
      }
    }
}

double largestChange(const Defect& a, const Defect& b) {
  const DefectSurface first(a), second(b);
  double most = 0;
  for (double x = -0.2; x <= 0.2; x += 0.00037)
    for (const double y : {-0.004, 0.0, 0.003})
      most = std::max(most, std::abs(first.height(x, y) - second.height(x, y)));
  return most;
}

// Not what the table says, but what the wheel rolls over: a key changes the surface where it applies, and only there.
TEST(Applicability, AKeyOfTheDefectChangesTheSurfaceWhereItAppliesAndOnlyThere) {
  const std::string points = "[[0, 0.02], [5, -0.1], [10, -0.2], [15, -0.1], [20, 0]]";
  for (const auto& shape : findParameter("defect.shape")->choices)
    for (const char* lateral : {"uniform", "parabolic"})
      for (const auto* parameter : conditional()) {
        if (parameter->kind != Kind::number && parameter->kind != Kind::boolean) continue;
        if (parameter->group != "defect" || parameter->key == "defect.move_nodes") continue;
        CaseDescription description = defaultCase();
        setValue(description, "defect.points", points);
        setValue(description, "defect.shape", shape);
        setValue(description, "defect.lateral", lateral);
        CaseDescription changed = description;
        const bool isNumber = parameter->kind == Kind::number;
        setValue(changed, parameter->key,
                 !isNumber                      ? "false"
                 : parameter->unit == "m"       ? "0.01"  // amid the points
                 : parameter->defaultValue == 0 ? "3"
                 : parameter->integer           ? "2"
                                                : formatDecimal(0.8 * parameter->defaultValue));
        const double change = largestChange(description.defect, changed.defect);
        EXPECT_EQ(change > 0, applies(description, *parameter))
            << parameter->key << " with " << shape << ", " << lateral << ": " << change;
      }
}

// A key without effect counts as its default: a half width means nothing where "parabolic" itself means nothing.
TEST(Applicability, WhatDependsOnAKeyWithoutEffectHasNone) {
  CaseDescription description = defaultCase();
  setValue(description, "defect.lateral", "parabolic");
  EXPECT_TRUE(applies(description, *findParameter("defect.half_width")));
  setValue(description, "defect.shape", "none");
  EXPECT_FALSE(applies(description, *findParameter("defect.half_width")));
  EXPECT_THAT(reasonWithoutEffect(description, *findParameter("defect.half_width")),
              HasSubstr("because defect.lateral has no effect either"));
}

TEST(Applicability, TorqueBesideATractionCoefficientIsReported) {
  CaseDescription description = defaultCase();
  setValue(description, "motion.torque", "8000");
  setValue(description, "motion.traction_coefficient", "0.1");
  const auto warnings = validate(description).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(toText(warnings[0]),
            "motion.torque is 8000 N m: no effect because motion.traction_coefficient is 0.1; applies if "
            "motion.traction_coefficient is 0");
}

}  // namespace
}  // namespace squat::cases
