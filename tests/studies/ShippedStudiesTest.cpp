// The studies that the manual offers can be started: cases, keys and values exist and every point makes a case.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "case/CaseDescription.h"
#include "studies/CaseStudy.h"

namespace squat::studies {
namespace {

TEST(ShippedStudies, everyPointOfEachIsACase) {
  std::ifstream text(std::string(SQUAT_SOURCE_DIR) + "/resources/studies/README.md");
  std::set<std::string> keys;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word, caseName, value;
    words >> word;
    if (word != "squat") continue;
    words >> word >> caseName;
    ASSERT_EQ(word, "study") << line;
    cases::CaseOverrides overrides;
    std::vector<std::string> variations;
    while (words >> word >> value) {
      if (word == "--vary") variations.push_back(value);
      if (word == "--set") {
        const auto equals = value.find('=');
        overrides.values.emplace_back(value.substr(0, equals), value.substr(equals + 1));
      }
    }
    caseName = std::string(SQUAT_SOURCE_DIR) + "/resources/cases/" + caseName + ".toml";
    const auto definition = studyOf(caseName, overrides, variations);
    for (const auto& point : gridOf(definition))
      EXPECT_NO_THROW(caseAt(definition, overrides, point)) << toText(definition, point);
    for (const auto& variation : definition.variations) keys.insert(variation.key);
  }
  // What the paper leaves open (severity) and what it holds fixed: K2, C2, K3, speed and L.
  const std::set<std::string> expected{
      "ballast.stiffness",        "defect.depth", "defect.length", "motion.speed", "pad.damping", "pad.stiffness",
      "track.defect_from_sleeper"};
  EXPECT_EQ(keys, expected);
}

}  // namespace
}  // namespace squat::studies
