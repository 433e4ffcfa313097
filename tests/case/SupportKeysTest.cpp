// Progressive pads as a case file states them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case/CaseFile.h"
#include "case/CaseText.h"
#include "case/ParameterValue.h"
#include "case/Validation.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;

// The problem of a text for a key; empty where it is accepted.
std::string refusal(const char* key, const char* text) {
  CaseDescription description = defaultCase();
  const auto problem = trySetValue(description, *findParameter(key), text);
  return problem ? toText(*problem) : std::string();
}

TEST(PadCurve, IsInMillimetresAndKilonewtons) {
  const auto c = parseCase("[pad]\ncurve = [[0, 0], [0.25, 40]]\npreload = 18\n", "x.toml");
  ASSERT_EQ(c.pad.curve.size(), 2u);
  EXPECT_EQ(c.pad.curve[1].compression, 0.25e-3);
  EXPECT_EQ(c.pad.curve[1].force, 40e3);
  EXPECT_EQ(c.pad.preload, 18e3);
  EXPECT_TRUE(defaultCase().pad.curve.empty());
}

TEST(PadCurve, MustRise) {
  const struct {
    const char *text, *said;
  } wrong[] = {{"[[0, 0]]", "at least two points"},
               {"[[0, 0], [0.1, 20], [0.1, 30]]", "Point 3: compressions must ascend"},
               {"[[0, 0], [0.1, 20], [0.2, 20]]", "Point 3: the force must rise"},
               {"[[0, 0], [0.1, 2000], [0.2, 9000]]", "Point 3: from one point to the next the stiffness"},
               {"[[0, 0], [80, 20]]", "Point 2: compressions go from -50 to 50 mm"},
               {"40", "Write pairs of numbers"}};
  for (const auto& [text, said] : wrong) EXPECT_THAT(refusal("pad.curve", text), HasSubstr(said)) << text;
  EXPECT_EQ(refusal("pad.curve", "[[-0.5, -1], [0, 0], [0.1, 20]]"), "");
  EXPECT_EQ(refusal("pad.curve", "[]"), "");
}

TEST(PadCurve, ReachesItsPreload) {
  CaseDescription c = defaultCase();
  setValue(c, "pad.curve", "[[0, 0], [0.1, 20]]");
  setValue(c, "pad.preload", "20");
  EXPECT_TRUE(validate(c).problems.empty());
  setValue(c, "pad.preload", "21");
  ASSERT_EQ(validate(c).problems.size(), 1u);
  EXPECT_EQ(validate(c).problems[0].key, "pad.preload");
  EXPECT_THAT(validate(c).problems[0].allowed, HasSubstr("0 to 20 kN"));
}

// Keys that a case does not use leave its hash as it was before they existed: results stay those of their case.
TEST(PadCurve, UnusedKeysLeaveTheHash) {
  CaseDescription c = defaultCase();
  const auto before = caseHash(c);
  setValue(c, "pad.preload", "10");  // no effect without a curve
  EXPECT_EQ(caseHash(c), before);
  setValue(c, "pad.curve", "[[0, 0], [0.1, 20]]");
  const auto curved = caseHash(c);
  EXPECT_NE(curved, before);
  setValue(c, "pad.preload", "11");
  EXPECT_NE(caseHash(c), curved);
}

}  // namespace
}  // namespace squat::cases
