#include "case/BeforeDefect.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "case/ShortHash.h"

namespace squat::cases {

bool countsBeforeDefect(const Parameter& parameter) {
  constexpr std::array<std::string_view, 12> others = {"title",
                                                       "note",
                                                       "wheelset.tread_deviation",
                                                       "wheelset.preset",
                                                       "track.preset",
                                                       "rail.preset",
                                                       "rail.irregularity_file",
                                                       "pad.dynamic",
                                                       "mesh.zone_before",
                                                       "mesh.zone_behind",
                                                       "output.filter_cutoff",
                                                       "output.cwt_voices"};
  return parameter.group != "defect" && parameter.group != "growth" &&
         std::find(others.begin(), others.end(), parameter.key) == others.end();
}

namespace {

std::vector<const Parameter*> differencesOfSide(const CaseDescription& one, const CaseDescription& other) {
  std::vector<const Parameter*> list;
  for (const auto& parameter : parameterTable())
    if (countsBeforeDefect(parameter) && valueText(one, parameter) != valueText(other, parameter))
      list.push_back(&parameter);
  return list;
}

bool isWhole(const CaseDescription& description) { return description.extent == ModelExtent::whole; }

}  // namespace

std::vector<const Parameter*> differencesBeforeDefect(const CaseDescription& one, const CaseDescription& other) {
  auto list = differencesOfSide(one, other);
  if (!isWhole(one) || !isWhole(other)) return list;
  for (const auto* parameter : differencesOfSide(rightOf(one), rightOf(other)))
    if (std::find(list.begin(), list.end(), parameter) == list.end()) list.push_back(parameter);
  return list;
}

bool hasMovedNodes(const CaseDescription& description) {
  return description.defect.moveNodes || (isWhole(description) && rightOf(description).defect.moveNodes);
}

std::string hashBeforeDefect(const CaseDescription& description) {
  std::string content;
  for (const auto& parameter : parameterTable())
    if (countsBeforeDefect(parameter)) content += parameter.key + "=" + valueText(description, parameter) + "\n";
  if (isWhole(description)) {
    const auto right = rightOf(description);
    for (const auto* parameter : differencesOfSide(description, right))
      if (parameter->key != "model.extent")
        content += std::string(rightGroup) + "." + parameter->key + "=" + valueText(right, *parameter) + "\n";
  }
  return shortHash(content);
}

}  // namespace squat::cases
