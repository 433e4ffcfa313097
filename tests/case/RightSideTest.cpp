// Keys of the right side: stated for it alone, and set back to what the left side has.
#include "case/RightSide.h"

#include <gtest/gtest.h>

#include "case/ParameterTable.h"
#include "case/ParameterValue.h"

namespace squat::cases {
namespace {

TEST(RightSide, isAsTheLeftOneAgain) {
  CaseDescription description = defaultCase();
  ASSERT_EQ(trySetRight(description, "defect.depth", "0.3"), std::nullopt);
  ASSERT_EQ(trySetRight(description, "pad.stiffness", "800"), std::nullopt);
  EXPECT_TRUE(isStatedOnRight(description, "defect.depth"));
  EXPECT_FALSE(isStatedOnRight(description, "defect.length"));
  setAsLeft(description, "defect.depth");
  EXPECT_FALSE(isStatedOnRight(description, "defect.depth"));
  EXPECT_DOUBLE_EQ(rightOf(description).defect.depth, description.defect.depth);
  EXPECT_DOUBLE_EQ(rightOf(description).pad.stiffness, 800e6);  // stays
  setAsLeft(description, "defect.length");                      // is already
  EXPECT_EQ(description.right.size(), 1u);
}

// Else the points of a file would stand under another file's name.
TEST(RightSide, pointsGoWithTheNameOfTheirFile) {
  CaseDescription description = defaultCase();
  setValue(description, "defect.points", "[[0, 0], [20, -0.1], [40, 0]]");
  trySetRight(description, "defect.file", "right.csv");
  trySetRight(description, "defect.points", "[[0, 0], [20, -0.3], [40, 0]]");
  setAsLeft(description, "defect.file");
  EXPECT_TRUE(description.right.empty());
  EXPECT_DOUBLE_EQ(rightOf(description).defect.points[1].height, -0.1e-3);
}

}  // namespace
}  // namespace squat::cases
