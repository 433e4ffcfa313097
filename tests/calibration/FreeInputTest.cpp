#include "calibration/FreeInput.h"

#include <gmock/gmock.h>

#include "calibration/SpaceFilling.h"
#include "core/Errors.h"

namespace squat::calibration {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusalOf(const std::vector<std::string>& texts) {
  try {
    freeInputsFromText(texts);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "taken";
}

TEST(FreeInput, ReadsKeyAndLimits) {
  const auto inputs = freeInputsFromText({"pad.stiffness=800:2000", "track.defect_from_sleeper=-0.1:0.2"});
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[0].key(), "pad.stiffness");
  EXPECT_EQ(inputs[0].low, 800);
  EXPECT_EQ(inputs[1].low, -0.1);
  EXPECT_EQ(inputs[1].high, 0.2);
}

TEST(FreeInput, RefusesWhatCannotBeSearched) {
  EXPECT_THAT(refusalOf({}), HasSubstr("KEY=LOW:HIGH"));
  EXPECT_THAT(refusalOf({"pad.stiffness=800"}), HasSubstr("KEY=LOW:HIGH"));
  EXPECT_THAT(refusalOf({"pad.stifness=800:900"}), HasSubstr("pad.stiffness"));
  EXPECT_THAT(refusalOf({"pad.stiffness=900:800"}), HasSubstr("LOW below HIGH"));
  EXPECT_THAT(refusalOf({"pad.stiffness=-5:800"}), HasSubstr("pad.stiffness is -5"));
  EXPECT_THAT(refusalOf({"defect.shape=1:2"}), HasSubstr("decimal number"));
  EXPECT_THAT(refusalOf({"pad.stiffness=1:2", "pad.stiffness=1:3"}), HasSubstr("given twice"));
}

TEST(FreeInput, ReportsEveryErrorAtOnce) {
  const auto text = refusalOf({"pad.stifness=1:2", "pad.stiffness=9:8"});
  EXPECT_THAT(text, HasSubstr("pad.stifness"));
  EXPECT_THAT(text, HasSubstr("LOW below HIGH"));
}

TEST(FreeInput, ValuesAreWhatTheirTextSays) {
  const auto inputs = freeInputsFromText({"pad.stiffness=800:2000"});
  const auto values = valuesAt(inputs, {1.0 / 3.0});
  EXPECT_EQ(valueText(values[0]), "1200");
  EXPECT_THAT(pointOf(inputs, values), ElementsAre(DoubleNear(1.0 / 3.0, 1e-6)));
  EXPECT_THAT(valuesAt(inputs, {1.7}), ElementsAre(2000));  // the cube ends at the limits
}

// In one dimension the recurrence is that of the golden ratio g: 1/2 + k/g modulo 1.
TEST(SpaceFilling, IsTheGoldenSequenceInOneDimension) {
  EXPECT_THAT(spaceFillingPoint(0, 1), ElementsAre(DoubleNear(0.118033988749895, 1e-12)));
  EXPECT_THAT(spaceFillingPoint(1, 1), ElementsAre(DoubleNear(0.736067977499790, 1e-12)));
}

// Of 1000 points in a cube every one of 125 boxes holds about eight: 4 to 12 here. Random points would leave boxes with
// fewer than 4 (Poisson's distribution about 8: 4 % of them, so that all 125 hold 4 with a chance of 0.005).
TEST(SpaceFilling, FillsTheCubeEvenly) {
  std::vector<int> boxes(125);
  for (std::size_t i = 0; i < 1000; ++i) {
    const auto point = spaceFillingPoint(i, 3);
    ++boxes[static_cast<std::size_t>(5 * point[0]) + 5 * static_cast<std::size_t>(5 * point[1]) +
            25 * static_cast<std::size_t>(5 * point[2])];
  }
  for (const int count : boxes) EXPECT_TRUE(count >= 4 && count <= 12) << count;
}

}  // namespace
}  // namespace squat::calibration
