#include "case/RightSide.h"

#include <algorithm>

#include "case/Applicability.h"
#include "case/NamedTables.h"
#include "case/ParameterValue.h"

namespace squat::cases {

namespace {

constexpr std::size_t longestShown = 60;  // letters of a key in a message

}  // namespace

std::string_view keyOnRight(std::string_view key) {
  return key.starts_with(rightGroup) && key.size() > rightGroup.size() && key[rightGroup.size()] == '.'
             ? key.substr(rightGroup.size() + 1)
             : std::string_view();
}

// The sides start as mirror images of each other, so that only their defects may differ; a profile is a table, which
// copies of a case have to take along, and of these there is one.
bool mayDiffer(std::string_view key) {
  const auto* parameter = key.starts_with("defect.") ? findParameter(key) : nullptr;
  return parameter && !isList(*parameter) && !namesTable(*parameter);
}

const Parameter* findOnEitherSide(std::string_view key) {
  const auto right = keyOnRight(key);
  if (right.empty()) return findParameter(key);
  return mayDiffer(right) ? findParameter(right) : nullptr;
}

CaseProblem noKeyOfRight(std::string_view key) {
  const std::string name = std::string(rightGroup) + "." + std::string(key.substr(0, longestShown));
  if (findParameter(key))
    return {name, "", "",
            "Both sides have the same; only keys of the defect may differ, without its profile. Remove it"};
  const std::string near = nearestKey(key);
  return {name, "", "",
          near.empty() || !mayDiffer(near)
              ? "No such key: only keys of the defect may differ on the right side. Remove it"
              : "No such key. Did you mean " + std::string(rightGroup) + "." + near + "?"};
}

CaseDescription rightOf(const CaseDescription& description) {
  CaseDescription right = description;
  right.right.clear();
  right.extent = ModelExtent::half;
  for (const auto& [key, text] : description.right) trySetValue(right, *findParameter(key), text);
  return right;
}

std::optional<CaseProblem> trySetRight(CaseDescription& description, std::string_view key, const std::string& text) {
  if (!mayDiffer(key)) return noKeyOfRight(key);
  const Parameter& parameter = *findParameter(key);
  CaseDescription right = rightOf(description);
  if (auto wrong = trySetValue(right, parameter, text)) return onRight(*wrong);
  auto& stated = description.right;
  std::erase_if(stated, [&](const auto& one) { return one.first == key; });
  // In the order of the table, whatever the order in which they were stated.
  const auto behind = std::find_if(stated.begin(), stated.end(),
                                   [&](const auto& one) { return findParameter(one.first) > &parameter; });
  stated.emplace(behind, key, valueText(right, parameter));
  return std::nullopt;
}

std::string reasonWithoutRight(const CaseDescription& description, const Parameter& parameter) {
  if (description.extent == ModelExtent::half) return "no effect because model.extent is half";
  const auto right = rightOf(description);
  return applies(right, parameter) ? std::string() : reasonWithoutEffect(right, parameter);
}

void requireHalf(const CaseDescription& description, const std::string& purpose) {
  if (description.extent == ModelExtent::half) return;
  throw CaseError({{"model.extent", "whole", "half for " + purpose,
                    "Set model.extent to half: both rails then have the defect, mirrored at the track centre"}});
}

CaseProblem onRight(CaseProblem problem) {
  problem.key = std::string(rightGroup) + "." + problem.key;
  return problem;
}

}  // namespace squat::cases
