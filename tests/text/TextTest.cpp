#include "text/Text.h"

#include <gmock/gmock.h>

#include "text/Csv.h"
#include "text/HeadingAnchor.h"
#include "text/Units.h"
#include "text/Utf8Text.h"

namespace squat::text {
namespace {

using ::testing::ElementsAre;

TEST(Text, TrimmedAndSplit) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
  EXPECT_THAT(split("a, b ,,c", ','), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split("", ','), ElementsAre(""));
  EXPECT_EQ(lowerCase("M\xC3\x96/S2"), "m\xC3\x96/s2");  // letters beyond ASCII as they are
}

TEST(Text, ShownFieldsAreShortAndPlain) {
  EXPECT_EQ(shown("a\tb"), "'a?b'");
  EXPECT_EQ(shown(std::string(50, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(Csv, FieldsWithMarksAreQuotedAndReadBack) {
  const std::string odd = "a,\"b\"\nc";
  EXPECT_EQ(csvField("plain"), "plain");
  EXPECT_EQ(csvField(odd), "\"a,\"\"b\"\"\nc\"");
  EXPECT_THAT(csvRecords("x," + csvField(odd) + "\n1,2\r\n3,"),
              ElementsAre(ElementsAre("x", odd), ElementsAre("1", "2"), ElementsAre("3", "")));
}

TEST(Csv, ShorterColumnsLeaveFieldsEmpty) {
  const std::vector<double> a{1, 0.5}, b{3};
  EXPECT_EQ(csvColumns({"a [m]", "b"}, {&a, &b}), "a [m],b\n1,3\n0.5,\n");
}

TEST(Units, PrintedWithTheirSigns) {
  EXPECT_EQ(printedUnit("m/s2"), "m/s²");
  EXPECT_EQ(printedUnit("(m/s2)2/Hz"), "(m/s²)²/Hz");
  EXPECT_EQ(printedUnit("us"), "µs");
  EXPECT_EQ(roundedText(103.44, "m/s2"), "103.4 m/s²");
  EXPECT_EQ(roundedText(0.5, "us"), "0.5 µs");
  EXPECT_EQ(roundedText(13710, "1"), "13710");
  EXPECT_EQ(printedUnit("km/h"), "km/h");
  EXPECT_EQ(withPrintedUnit("peak 2 prominence [(m/s2)2/Hz]"), "peak 2 prominence [(m/s²)²/Hz]");
}

TEST(Units, KnownByTheirUsualNames) {
  EXPECT_EQ(bareUnit(" [km/h] "), "km/h");
  EXPECT_TRUE(isUnit("[anything]"));
  EXPECT_FALSE(isUnit("height"));
  ASSERT_NE(findUnit("KM/H"), nullptr);
  EXPECT_DOUBLE_EQ(findUnit("km/h")->factor, 1 / 3.6);
}

// As GitHub names the headings of a page; by hand.
// RFC 3629: U+00B5 takes two bytes, U+2215 three; half of a surrogate pair is no letter.
TEST(Utf8Text, LettersOfUtf16) {
  const std::uint16_t letters[] = {'a', 0x00B5, 0x2215, 0xD83D};
  EXPECT_EQ(utf8FromUtf16(letters), "a\xC2\xB5\xE2\x88\x95?");
}

TEST(HeadingAnchor, LowerCaseWithHyphens) {
  EXPECT_EQ(headingAnchor("Parts of other work"), "parts-of-other-work");
  EXPECT_EQ(headingAnchor("Stick, slip: `run_1`"), "stick-slip-run_1");
  EXPECT_EQ(headingAnchor("Größe"), "größe");
}

}  // namespace
}  // namespace squat::text
