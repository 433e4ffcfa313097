#include "case/RightSide.h"

#include <algorithm>
#include <array>

#include "case/Applicability.h"
#include "case/BeforeDefect.h"
#include "case/NamedTables.h"
#include "case/ParameterValue.h"

namespace squat::cases {

namespace {

constexpr std::size_t longestShown = 60;  // letters of a key in a message
constexpr std::string_view whatMayDiffer =
    "the right side may have its own defect, stiffness and damping of pads and ballast, sprung mass and suspension, "
    "friction, lateral offset and seed of the irregularity";

}  // namespace

std::string_view keyOnRight(std::string_view key) {
  return key.starts_with(rightGroup) && key.size() > rightGroup.size() && key[rightGroup.size()] == '.'
             ? key.substr(rightGroup.size() + 1)
             : std::string_view();
}

bool mayDiffer(std::string_view key) {
  // Of the whole groups but for what holds in the frequency domain alone, and for curves.
  constexpr std::array<std::string_view, 4> groups{"defect", "pad", "ballast", "suspension"};
  constexpr std::array<std::string_view, 3> single{"contact.friction", "motion.lateral_offset",
                                                   "rail.irregularity_seed"};
  const auto* parameter = findParameter(key);
  if (!parameter || key.ends_with(".loss_factor")) return false;
  const bool isTable = isList(*parameter) || parameter->kind == Kind::forceCurve || parameter->kind == Kind::text;
  if (isTable && parameter->group != "defect") return false;
  // Of the wheelset; what the meshes of both sides have in common; where the pads' common curve begins.
  if (key.starts_with("suspension.lateral_") || key == "pad.length" || key == "pad.width" || key == "pad.preload")
    return false;
  const auto among = [](const auto& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  return among(groups, parameter->group) || among(single, key);
}

bool startsAlike(const CaseDescription& description) {
  const auto right = rightOf(description);
  return std::none_of(description.right.begin(), description.right.end(), [&](const auto& stated) {
    const auto& parameter = *findParameter(stated.first);
    return countsBeforeDefect(parameter) && valueText(right, parameter) != valueText(description, parameter);
  });
}

const Parameter* findOnEitherSide(std::string_view key) {
  const auto right = keyOnRight(key);
  if (right.empty()) return findParameter(key);
  return mayDiffer(right) ? findParameter(right) : nullptr;
}

CaseProblem noKeyOfRight(std::string_view key) {
  const std::string name = std::string(rightGroup) + "." + std::string(key.substr(0, longestShown));
  if (findParameter(key)) return {name, "", "", "Both sides have the same. Remove it; " + std::string(whatMayDiffer)};
  const std::string near = nearestKey(key);
  return {name, "", "",
          near.empty() || !mayDiffer(near) ? "No such key. Remove it; " + std::string(whatMayDiffer)
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

bool isStatedOnRight(const CaseDescription& description, std::string_view key) {
  return std::any_of(description.right.begin(), description.right.end(),
                     [&](const auto& stated) { return stated.first == key; });
}

void setAsLeft(CaseDescription& description, std::string_view key) {
  // Of one file: its name and the numbers from it.
  const auto isOf = [](const NamedTable& table, std::string_view one) {
    return table.fileKey == one ||
           std::find(table.valueKeys.begin(), table.valueKeys.end(), one) != table.valueKeys.end();
  };
  const auto goes = [&](const std::string& stated) {
    return stated == key || std::any_of(namedTables().begin(), namedTables().end(), [&](const NamedTable& table) {
             return isOf(table, key) && isOf(table, stated);
           });
  };
  std::erase_if(description.right, [&](const auto& stated) { return goes(stated.first); });
}

std::string reasonWithoutRight(const CaseDescription& description, const Parameter& parameter) {
  return reasonWithoutRight(description, rightOf(description), parameter);
}

std::string reasonWithoutRight(const CaseDescription& description, const CaseDescription& right,
                               const Parameter& parameter) {
  if (description.extent == ModelExtent::half) return "no effect because model.extent is half";
  return applies(right, parameter) ? std::string() : reasonWithoutEffect(right, parameter);
}

void requireHalf(const CaseDescription& description, const std::string& purpose) {
  if (description.extent == ModelExtent::half) return;
  throw CaseError({{"model.extent", "whole", "half for " + purpose,
                    "Set model.extent to half: both rails then have the defect, mirrored at the track centre"}});
}

void requireSingleWheelset(const CaseDescription& description, const std::string& purpose) {
  if (!description.bogie.hasSecond()) return;
  throw CaseError({{"bogie.wheelbase", valueText(description, *findParameter("bogie.wheelbase")) + " m",
                    "0 for " + purpose, "Remove bogie.wheelbase: a single wheelset then rolls over the defect"}});
}

CaseProblem onRight(CaseProblem problem) {
  problem.key = std::string(rightGroup) + "." + problem.key;
  return problem;
}

}  // namespace squat::cases
