#include "case/BeforeDefect.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "case/ParameterValue.h"
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

std::vector<const Parameter*> differencesBeforeDefect(const CaseDescription& one, const CaseDescription& other) {
  std::vector<const Parameter*> list;
  for (const auto& parameter : parameterTable())
    if (countsBeforeDefect(parameter) && valueText(one, parameter) != valueText(other, parameter))
      list.push_back(&parameter);
  return list;
}

std::string hashBeforeDefect(const CaseDescription& description) {
  std::string content;
  for (const auto& parameter : parameterTable())
    if (countsBeforeDefect(parameter)) content += parameter.key + "=" + valueText(description, parameter) + "\n";
  return shortHash(content);
}

}  // namespace squat::cases
