// Setting values by key and text, as --set and the studio's form do.
#include "case/ParameterValue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "case/PointsText.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;

CaseProblem problemOf(const char* key, const char* text) {
  CaseDescription description = defaultCase();
  const std::string before = valueText(description, *findParameter(key));
  const auto problem = trySetValue(description, *findParameter(key), text);
  EXPECT_TRUE(problem.has_value()) << key << " = " << text;
  EXPECT_EQ(valueText(description, *findParameter(key)), before) << "a refused value must change nothing";
  return problem.value_or(CaseProblem{});
}

TEST(ParameterValue, SetsNumbersInTheUnitOfTheTable) {
  CaseDescription description = defaultCase();
  setValue(description, "pad.stiffness", "550");
  EXPECT_EQ(description.pad.stiffness, 550e6);
  setValue(description, "mesh.wheel_sectors", "82");
  EXPECT_EQ(description.mesh.wheelSectors, 82);
  setValue(description, "output.cwt_voices", "32.0");
  EXPECT_EQ(description.output.cwtVoices, 32);
  EXPECT_EQ(numberInUnit(description, *findParameter("pad.stiffness")), 550);
}

TEST(ParameterValue, RangesIncludeTheirEnds) {
  CaseDescription description = defaultCase();
  const Parameter& friction = *findParameter("contact.friction");
  EXPECT_FALSE(trySetValue(description, friction, "0"));
  EXPECT_FALSE(trySetValue(description, friction, "1"));
  EXPECT_TRUE(trySetValue(description, friction, "1.0000000000000002"));
  EXPECT_TRUE(trySetValue(description, friction, "-1e-300"));
}

TEST(ParameterValue, ProblemSaysKeyValueRangeAndUnit) {
  const CaseProblem problem = problemOf("pad.stiffness", "-5");
  EXPECT_EQ(problem.key, "pad.stiffness");
  EXPECT_EQ(problem.value, "-5");
  EXPECT_EQ(problem.allowed, "1 to 20000 MN/m");
  EXPECT_FALSE(problem.advice.empty());
}

TEST(ParameterValue, RefusesWhatIsNoNumber) {
  for (const char* text : {"nan", "inf", "-inf", "", "abc", "1e400", "true", "0x10"}) problemOf("motion.speed", text);
  EXPECT_THAT(problemOf("motion.speed", "27,5").advice, HasSubstr("decimal point"));
  EXPECT_THAT(problemOf("mesh.wheel_sectors", "64.5").advice, HasSubstr("whole number"));
}

TEST(ParameterValue, RefusesUnknownNamesAndWords) {
  EXPECT_THAT(problemOf("track.rail_ends", "Free").allowed, HasSubstr("free, clamped, absorbing"));
  EXPECT_EQ(problemOf("rail.plastic", "yes").allowed, "true or false");
}

TEST(ParameterValue, RefusesTextThatNoFileCouldHold) {
  problemOf("title", "bell \a");
  problemOf("title", "not UTF-8: \xff");
  problemOf("title", "overlong \xC0\xAF");
  problemOf("note", std::string(20000, 'x').c_str());
  CaseDescription description = defaultCase();
  setValue(description, "title", "Über die Schwelle: \"µ\" \\ 55 %");
  EXPECT_EQ(description.title, "Über die Schwelle: \"µ\" \\ 55 %");
}

TEST(ParameterValue, LongValuesAreShownShort) {
  EXPECT_LT(problemOf("motion.speed", std::string(100000, '9').c_str()).value.size(), 80u);
}

TEST(ParameterValue, UnknownKeyNamesTheNearest) {
  CaseDescription description = defaultCase();
  try {
    setValue(description, "motion.sped", "30");
    FAIL() << "an unknown key was taken";
  } catch (const CaseError& error) {
    ASSERT_EQ(error.problems().size(), 1u);
    EXPECT_EQ(error.problems()[0].key, "motion.sped");
    EXPECT_THAT(error.what(), HasSubstr("motion.speed"));
  }
}

TEST(ParameterValue, ChecksValuesThatStandInADescription) {
  CaseDescription description = defaultCase();
  const Parameter& speed = *findParameter("motion.speed");
  EXPECT_FALSE(checkRange(description, speed));
  for (const double value :
       {0.0, 1e9, -30.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    description.motion.speed = value;
    EXPECT_TRUE(checkRange(description, speed)) << value;
  }
  description.defect.shape = static_cast<DefectShape>(17);
  EXPECT_TRUE(checkRange(description, *findParameter("defect.shape")));
}

TEST(PointsText, ReadsAndWritesPairs) {
  const auto points = parsePoints("[[0, 0], [5,-0.1],[ 10 , 1e-3 ], ]", -3);
  ASSERT_TRUE(points.has_value());
  ASSERT_EQ(points->size(), 3u);
  EXPECT_EQ((*points)[1].position, 0.005);
  EXPECT_EQ((*points)[1].height, -0.0001);
  EXPECT_EQ(formatPoints(*points, -3), "[[0, 0], [5, -0.1], [10, 0.001]]");
  EXPECT_EQ(parsePoints("[]", -3)->size(), 0u);
}

TEST(PointsText, RefusesOtherText) {
  for (const char* text : {"", "[", "[]]", "[[0]]", "[[0, 1, 2]]", "[[0, nan]]", "[0, 1]", "[[0, 1] [2, 3]]", "[[0, 1]",
                           "[[a, b]]", "{}", "[[0,1],,[2,3]]"})
    EXPECT_FALSE(parsePoints(text, -3).has_value()) << text;
}

TEST(PointsText, NamesTheMistakeOfAProfile) {
  EXPECT_EQ(pointsMistake({{0, 0}, {0.005, -1e-4}}), "");
  EXPECT_THAT(pointsMistake({{0, 0}}), HasSubstr("two points"));
  EXPECT_THAT(pointsMistake({{0, 0}, {0.01, 0}, {0.005, 0}}), HasSubstr("Point 3"));
  EXPECT_THAT(pointsMistake({{0, 0}, {0, 0}}), HasSubstr("the one before"));
  EXPECT_THAT(pointsMistake({{0, 0}, {1, 0.2}}), HasSubstr("50 mm"));
  EXPECT_FALSE(pointsMistake({{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}}).empty());
  EXPECT_FALSE(pointsMistake({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}}).empty());
}

}  // namespace
}  // namespace squat::cases
