#include "studies/StudyGrid.h"

#include <gmock/gmock.h>

#include "core/Errors.h"

namespace squat::studies {
namespace {

using ::testing::ElementsAre;

TEST(StudyGrid, rangesAndLists) {
  EXPECT_THAT(variationFromText("defect.length=20:60:5").values, ElementsAre("20", "30", "40", "50", "60"));
  EXPECT_THAT(variationFromText(" a.b = 0.1 : 0.3 : 3 ").values, ElementsAre("0.1", "0.2", "0.3"));
  EXPECT_THAT(variationFromText("x=-1:1:3").values, ElementsAre("-1", "0", "1"));
  EXPECT_THAT(variationFromText("x=5:5:1").values, ElementsAre("5"));
  EXPECT_THAT(variationFromText("x=60:20:2").values, ElementsAre("60", "20"));
  EXPECT_THAT(variationFromText("k=uniform, parabolic").values, ElementsAre("uniform", "parabolic"));
  for (const auto* bad : {"", "x", "x=", "=1:2:3", "x=1:2", "x=1:2:0", "x=1:2:1", "x=1:2:2.5", "x=a:2:3", "x=1:2:1001",
                          "x=1,,2", "x=1,1", "x=1:inf:3", "x=1:2:3:4"})
    EXPECT_THROW(variationFromText(bad), CaseError) << bad;
}

TEST(StudyGrid, lastKeyChangesFastest) {
  const StudyDefinition definition{"c", "h", {variationFromText("a=1:2:2"), variationFromText("b=x,y,z")}};
  const auto points = gridOf(definition);
  ASSERT_EQ(points.size(), 6u);
  EXPECT_THAT(points[0].values, ElementsAre("1", "x"));
  EXPECT_THAT(points[1].values, ElementsAre("1", "y"));
  EXPECT_THAT(points[5].values, ElementsAre("2", "z"));
  EXPECT_EQ(points[5].index, 5u);
  EXPECT_EQ(toText(definition, points[4]), "a=2, b=y");
}

TEST(StudyGrid, refusesAbsurdGrids) {
  EXPECT_THROW(gridOf({"c", "h", {}}), CaseError);
  EXPECT_THROW(gridOf({"c", "h", {variationFromText("a=1:2:2"), variationFromText("a=3,4")}}), CaseError);
  EXPECT_THROW(gridOf({"c", "h", {variationFromText("a=1:2:1000"), variationFromText("b=1:2:11")}}), CaseError);
}

}  // namespace
}  // namespace squat::studies
