#include "commands/Study.h"

#include <gmock/gmock.h>

#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::commands {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    variationFromText(text);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Study, VariationsAreSpacedOrListed) {
  EXPECT_THAT(variationFromText("motion.speed=25:35:3").values, ElementsAre("25", "30", "35"));
  EXPECT_THAT(variationFromText("defect.depth=0.1:0.5:5").values, ElementsAre("0.1", "0.2", "0.3", "0.4", "0.5"));
  EXPECT_THAT(variationFromText("motion.speed=30:40:1").values, ElementsAre("30"));
  EXPECT_THAT(variationFromText("defect.shape=cosine,cut").values, ElementsAre("cosine", "cut"));
}

TEST(Study, WrongVariationsAreRefusedWithAdvice) {
  EXPECT_THAT(refusal("motion.speed"), HasSubstr("KEY=FROM:TO:COUNT"));
  EXPECT_THAT(refusal("motion.speed=1:2:0"), HasSubstr("count from 1"));
  EXPECT_THAT(refusal("motion.speed=1:2:many"), HasSubstr("count from 1"));
  EXPECT_THAT(refusal("motion.speed=a:2:3"), HasSubstr("KEY=FROM:TO:COUNT"));
  EXPECT_THAT(refusal("motion.sped=1:2:3"), HasSubstr("motion.speed"));
  EXPECT_THROW(studyRuns({{"a", {"1"}}, {"a", {"2"}}}), CaseError);
  EXPECT_THROW(studyRuns({{"a", std::vector<std::string>(200, "1")}, {"b", std::vector<std::string>(200, "1")}}),
               CaseError);
}

TEST(Study, TheGridHasEveryCombinationOnceTheLastKeyFastest) {
  const auto runs = studyRuns({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[0].name, "001");
  EXPECT_THAT(runs[1].sets, ElementsAre(std::pair<std::string, std::string>{"a", "1"},
                                        std::pair<std::string, std::string>{"b", "y"}));
  EXPECT_THAT(runs[5].sets, ElementsAre(std::pair<std::string, std::string>{"a", "2"},
                                        std::pair<std::string, std::string>{"b", "z"}));
}

TEST(Study, TheTableNamesUnitsAndFailures) {
  const auto runs = studyRuns({{"motion.speed", {"25", "30"}}});
  const auto text =
      studyCsv({{runs[0], "done", {{"peak [m/s2]", 101.5}}}, {runs[1], "failed: no contact, step 3", {}}});
  EXPECT_EQ(text,
            "run,motion.speed [m/s],status,peak [m/s2]\n001,25,done,101.5\n002,30,\"failed: no contact, step 3\",\n");
}

TEST(Study, FeaturesOfARunHoldTheExtremesOfTheForce) {
  auto result = testing::sampleResult(50);
  result.signals = {{"contact_force", "N", "", std::vector<double>(50, 8e4)}};
  result.signals[0].values[7] = 9e4;
  EXPECT_THAT(studyFeatures(result), ElementsAre(std::pair<std::string, double>{"largest contact force [N]", 9e4},
                                                 std::pair<std::string, double>{"smallest contact force [N]", 8e4}));
}

}  // namespace
}  // namespace squat::commands
