// Progressive pads and seats that differ, as a case file states them.
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

TEST(Seats, AreTablesOfTheTrack) {
  const auto c = parseCase(
      "[track]\nlength = 6\n[[track.seats]]\nsleeper = 2\npad_stiffness = 300\npad_damping = 12.5\n"
      "[[track.seats]]\nsleeper = -1\nballast_stiffness = 10\nballast_damping = 4\ngap = 0.75\n",
      "x.toml");
  ASSERT_EQ(c.track.seats.size(), 2u);
  EXPECT_EQ(c.track.seats[0].sleeper, 2);
  EXPECT_EQ(c.track.seats[0].padStiffness, 300e6);
  EXPECT_EQ(c.track.seats[0].padDamping, 12.5e3);
  EXPECT_FALSE(c.track.seats[0].gap || c.track.seats[0].ballastStiffness);
  EXPECT_EQ(c.track.seats[1].sleeper, -1);
  EXPECT_EQ(c.track.seats[1].ballastStiffness, 10e6);
  EXPECT_EQ(c.track.seats[1].ballastDamping, 4e3);
  EXPECT_EQ(c.track.seats[1].gap, 0.75e-3);
  EXPECT_THAT(describeTable(c), HasSubstr("2 seats"));
  EXPECT_THAT(describeJson(c), HasSubstr("\"pad_stiffness\": 300"));
}

TEST(Seats, SayWhatIsWrong) {
  const struct {
    const char *text, *said;
  } wrong[] = {{"[{ pad_stiffness = 300 }]", "Seat 1: name its sleeper"},
               {"[{ sleeper = 0.5 }]", "sleeper is a whole number"},
               {"[{ sleeper = 0 }, { sleeper = 0 }]", "Seat 2: an earlier one has the same sleeper"},
               {"[{ sleeper = 0, pad_stifness = 300 }]", "Seat 1: there is no key pad_stifness"},
               {"[{ sleeper = 0, pad_stiffness = 0 }]", "pad_stiffness goes from 1 to 20000 MN/m"},
               {"[{ sleeper = 0, gap = -1 }]", "gap goes from 0 to 20 mm"},
               {"[{ sleeper = 0, gap = 1, gap = 2 }]", "gap is given twice"},
               {"{ sleeper = 0 }", "Write tables like"},
               {"[{ sleeper = 0 } { sleeper = 1 }]", "Write tables like"}};
  for (const auto& [text, said] : wrong) EXPECT_THAT(refusal("track.seats", text), HasSubstr(said)) << text;
  EXPECT_EQ(refusal("track.seats", "[]"), "");
}

// Ten metres with 0.6 m between sleepers: eight each way of the one nearest to the middle of the run.
TEST(Seats, MustExist) {
  CaseDescription c = defaultCase();
  setValue(c, "track.length", "10");
  setValue(c, "track.seats", "[{ sleeper = 8, gap = 1 }]");
  EXPECT_TRUE(validate(c).problems.empty());
  setValue(c, "track.seats", "[{ sleeper = 12, gap = 1 }]");
  ASSERT_EQ(validate(c).problems.size(), 1u);
  const auto problem = validate(c).problems[0];
  EXPECT_EQ(problem.key, "track.seats");
  EXPECT_THAT(problem.advice, HasSubstr("There is no sleeper 12"));
  EXPECT_THAT(problem.allowed, HasSubstr("sleepers from -8 to 8"));
}

// Keys that a case does not use leave its hash as it was before they existed: results stay those of their case.
TEST(Seats, UnusedKeysLeaveTheHash) {
  CaseDescription c = defaultCase();
  const auto before = caseHash(c);
  setValue(c, "pad.preload", "10");  // no effect without a curve
  EXPECT_EQ(caseHash(c), before);
  setValue(c, "pad.curve", "[[0, 0], [0.1, 20]]");
  const auto curved = caseHash(c);
  EXPECT_NE(curved, before);
  setValue(c, "pad.preload", "11");
  EXPECT_NE(caseHash(c), curved);
  setValue(c, "track.seats", "[{ sleeper = 1, gap = 0.5 }]");
  const auto seated = caseHash(c);
  setValue(c, "track.seats", "[{ sleeper = 1, gap = 0.6 }]");
  EXPECT_NE(caseHash(c), seated);
}

}  // namespace
}  // namespace squat::cases
