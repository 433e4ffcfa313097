#include "case/RightSide.h"

#include <algorithm>
#include <array>

#include "case/ParameterValue.h"

namespace squat::cases {

namespace {

// Where they differ, both sides still start as mirror images of each other.
constexpr std::array<std::string_view, 1> groups{"defect."};

}  // namespace

std::string_view keyOnRight(std::string_view key) {
  return key.starts_with(rightGroup) && key.size() > rightGroup.size() && key[rightGroup.size()] == '.'
             ? key.substr(rightGroup.size() + 1)
             : std::string_view();
}

bool mayDiffer(std::string_view key) {
  return findParameter(key) &&
         std::any_of(groups.begin(), groups.end(), [&](std::string_view start) { return key.starts_with(start); });
}

const Parameter* findOnEitherSide(std::string_view key) {
  const auto right = keyOnRight(key);
  if (right.empty()) return findParameter(key);
  return mayDiffer(right) ? findParameter(right) : nullptr;
}

CaseProblem noKeyOfRight(std::string_view key) {
  const std::string name = std::string(rightGroup) + "." + std::string(key);
  constexpr const char* allowed = "a key of defect";
  if (findParameter(key)) return {name, "the same on both sides", allowed, "Remove it"};
  const std::string near = nearestKey(key);
  return {
      name, "no such key", allowed,
      near.empty() || !mayDiffer(near) ? "Remove it" : "Did you mean " + std::string(rightGroup) + "." + near + "?"};
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
  const auto own = std::find_if(stated.begin(), stated.end(), [&](const auto& one) { return one.first == key; });
  if (own != stated.end()) own->second = valueText(right, parameter);
  if (own == stated.end()) stated.emplace_back(key, valueText(right, parameter));
  return std::nullopt;
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
