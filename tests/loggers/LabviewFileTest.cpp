// LabVIEW measurement files as its writer lays them out (NI's specification of the .lvm format); the expected values
// stand in the text of each file.
#include "loggers/LabviewFile.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

using ::testing::DoubleEq;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::NanSensitiveDoubleEq;

std::string lvmHead(const std::string& axis, const std::string& more = "Decimal_Separator\t.\n") {
  return "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\n" + more +
         "Multi_Headings\tYes\nX_Columns\t" + axis +
         "\nTime_Pref\tAbsolute\nOperator\ttest\nDate\t2026/11/27\nTime\t09:30:00.5\n***End_of_Header***\t\n\t\n";
}

std::string lvmTwoChannels(const std::string& x0, const std::string& step, const std::string& dimension = "Time") {
  return "Channels\t2\t\t\nSamples\t3\t3\t\nDate\t2026/11/27\t2026/11/27\t\nTime\t09:30:00.5\t09:30:00.5\t\n"
         "Y_Unit_Label\tm/s^2\tg\t\nX_Dimension\t" +
         dimension + "\t" + dimension + "\t\nX0\t" + x0 + "\t" + x0 + "\t\nDelta_X\t" + step + "\t" + step +
         "\t\n***End_of_Header***\t\t\t\nX_Value\tleft box\tright box\tComment\n";
}

// The whole text of the error, for its cause and its place.
std::string lvmError(const std::string& text) {
  try {
    parseLabviewFile(text, "test.lvm");
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LabviewFile, IsKnownByItsFirstWords) {
  EXPECT_TRUE(isLabviewFile("LabVIEW Measurement\t\r\nWriter_Version"));
  EXPECT_TRUE(isLabviewFile("\xEF\xBB\xBFLabVIEW Measurement"));
  EXPECT_FALSE(isLabviewFile("LabVIEW"));
  EXPECT_FALSE(isLabviewFile("time;LabVIEW Measurement"));
  EXPECT_THAT(lvmError("t,a\n0,1\n"), HasSubstr("is not a LabVIEW measurement file"));
}

TEST(LabviewFile, WithoutXTheRateIsThatOfDeltaX) {
  // Comments are empty, filled or missing.
  const auto read = parseLabviewFile(lvmHead("No") + lvmTwoChannels("0.0000000000000000E+0", "1.953125E-5") +
                                         "\t0.5\t-1.25\t\n\t1.5E+1\t2\tstart, here\n\t-3\t4\n",
                                     "test.lvm");
  EXPECT_DOUBLE_EQ(read.rate, 51200);
  ASSERT_EQ(read.table.columns.size(), 2);
  EXPECT_EQ(read.table.columns[0].name, "left box");
  EXPECT_EQ(read.table.columns[0].unit, "m/s^2");
  EXPECT_EQ(read.table.columns[1].name, "right box");
  EXPECT_EQ(read.table.columns[1].unit, "g");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0.5, 15, -3));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(-1.25, 2, 4));
  EXPECT_THAT(read.table.lines, ElementsAre(1, 2, 3));
  EXPECT_EQ(read.table.rowWord, "sample");
  EXPECT_EQ(read.table.path, "test.lvm");
  EXPECT_THAT(read.notes, IsEmpty());
}

TEST(LabviewFile, OneXIsTheTimeWithoutItsRounding) {
  // At 51.2 kHz LabVIEW's six decimals round steps of 19.53125 us to 19 and 20 us.
  const auto read = parseLabviewFile(
      lvmHead("One") + lvmTwoChannels("0", "1.953125E-5") + "0.000000\t1\t4\n0.000020\t2\t5\n0.000039\t3\t6\n",
      "test.lvm");
  EXPECT_EQ(read.rate, 0);
  ASSERT_EQ(read.table.columns.size(), 3);
  EXPECT_EQ(read.table.columns[0].name, "time");
  EXPECT_EQ(read.table.columns[0].unit, "s");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0, DoubleEq(1.953125e-5), DoubleEq(3.90625e-5)));
  EXPECT_THAT(read.table.columns[2].values, ElementsAre(4, 5, 6));

  // Where X is not at equal steps it stays as it is written.
  const auto other = parseLabviewFile(
      lvmHead("One") + lvmTwoChannels("0", "1.953125E-5") + "0.5\t1\t4\n0.75\t2\t5\n0.875\t3\t6\n", "test.lvm");
  EXPECT_THAT(other.table.columns[0].values, ElementsAre(0.5, 0.75, 0.875));
}

TEST(LabviewFile, AnXThatIsNoTimeKeepsItsName) {
  const std::string rows = "10\t1\t4\n12\t2\t5\n14\t3\t6\n";
  const auto one = parseLabviewFile(lvmHead("One") + lvmTwoChannels("10", "2", "Frequency") + rows, "test.lvm");
  EXPECT_EQ(one.table.columns[0].name, "X_Value");
  EXPECT_EQ(one.table.columns[0].unit, "");
  EXPECT_THAT(one.table.columns[0].values, ElementsAre(10, 12, 14));
  // Without a column it is made from X0 and Delta_X.
  const auto none =
      parseLabviewFile(lvmHead("No") + lvmTwoChannels("10", "2", "Frequency") + "\t1\t4\n\t2\t5\n\t3\t6\n", "test.lvm");
  EXPECT_EQ(none.rate, 0);
  EXPECT_EQ(none.table.columns[0].name, "X_Value");
  EXPECT_THAT(none.table.columns[0].values, ElementsAre(10, 12, 14));
}

const char* const lvmThreeAxes =
    "Channels\t3\t\t\t\t\t\nSamples\t3\t\t3\t\t2\t\nY_Unit_Label\tg\t\tm/s2\t\tV\t\n"
    "X_Dimension\tTime\t\tTime\t\tTime\t\nX0\t0.0\t\t0.0\t\t0.0\t\nDelta_X\t0.25\t\t0.25\t\t0.5\t\n"
    "***End_of_Header***\t\t\t\t\t\t\nX_Value\tax\tX_Value\tay\tX_Value\tspeed\tComment\n";

TEST(LabviewFile, OfSeveralXTheLongestIsKept) {
  const auto read = parseLabviewFile(
      lvmHead("Multi") + lvmThreeAxes + "0\t1\t0\t4\t0\t7\n0.25\t2\t0.25\t5\t0.5\t8\n0.5\t3\t0.5\t6\t\t\n", "test.lvm");
  ASSERT_EQ(read.table.columns.size(), 3);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0, 0.25, 0.5));
  EXPECT_EQ(read.table.columns[1].name, "ax");
  EXPECT_EQ(read.table.columns[1].unit, "g");
  EXPECT_EQ(read.table.columns[2].name, "ay");
  EXPECT_EQ(read.table.columns[2].unit, "m/s2");
  EXPECT_THAT(read.table.columns[2].values, ElementsAre(4, 5, 6));
  EXPECT_THAT(read.notes, ElementsAre("1 channel has another X: left out"));
}

TEST(LabviewFile, ChannelsOfOneXEachAreAllKept) {
  const auto read =
      parseLabviewFile(lvmHead("Multi") + lvmThreeAxes + "0\t1\t0\t4\t0\t7\n0.25\t2\t0.25\t5\t0.25\t8\n", "test.lvm");
  ASSERT_EQ(read.table.columns.size(), 4);
  EXPECT_EQ(read.table.columns[3].name, "speed");
  EXPECT_EQ(read.table.columns[3].unit, "V");
  EXPECT_THAT(read.table.columns[3].values, ElementsAre(7, 8));
  EXPECT_THAT(read.notes, IsEmpty());
}

TEST(LabviewFile, SeparatorsAreThoseOfTheHeader) {
  const auto german = parseLabviewFile(
      "LabVIEW Measurement;\r\nSeparator;Semicolon\r\nDecimal_Separator;,\r\nX_Columns;No\r\n***End_of_Header***;\r\n"
      ";\r\nChannels;1;\r\nY_Unit_Label;g;\r\nX_Dimension;Time;\r\nX0;0,0E+0;\r\nDelta_X;0,0005;\r\n"
      "***End_of_Header***;;\r\nX_Value;box;Comment\r\n;1,5;\r\n;-2,25\r\n",
      "test.lvm");
  EXPECT_DOUBLE_EQ(german.rate, 2000);
  EXPECT_THAT(german.table.columns[0].values, ElementsAre(1.5, -2.25));

  const auto comma = parseLabviewFile(
      "LabVIEW Measurement,\nSeparator,Comma\nDecimal_Separator,.\nX_Columns,No\n***End_of_Header***,\n,\n"
      "Channels,1,\nDelta_X,0.5,\n***End_of_Header***,,\nX_Value,box,Comment\n,1.5,\n,2.5,\n",
      "test.lvm");
  EXPECT_DOUBLE_EQ(comma.rate, 2);
  EXPECT_THAT(comma.table.columns[0].values, ElementsAre(1.5, 2.5));

  // Earlier versions do not state the decimal separator.
  const auto old =
      parseLabviewFile(lvmHead("No", "") + lvmTwoChannels("0,0E+0", "0,5000") + "\t1,5\t2,5\n\t3\t4,25\n", "test.lvm");
  EXPECT_DOUBLE_EQ(old.rate, 2);
  EXPECT_THAT(old.table.columns[1].values, ElementsAre(2.5, 4.25));
}

TEST(LabviewFile, SegmentsFollowOn) {
  const std::string first = lvmHead("No") + lvmTwoChannels("0.0", "0.5") + "\t1\t4\n\t2\t5\n\n";
  const auto joined = parseLabviewFile(first + lvmTwoChannels("1.0", "0.5") + "\t3\t6\n", "test.lvm");
  EXPECT_THAT(joined.table.columns[0].values, ElementsAre(1, 2, 3));
  EXPECT_THAT(joined.notes, IsEmpty());

  const auto gap = parseLabviewFile(first + lvmTwoChannels("8.0", "0.5") + "\t3\t6\n", "test.lvm");
  EXPECT_THAT(gap.table.columns[0].values, ElementsAre(1, 2, 3));
  EXPECT_THAT(gap.notes, ElementsAre("1 of 2 segments do not follow on in X: joined without a gap"));

  const auto other = parseLabviewFile(first + lvmTwoChannels("1.0", "0.25") + "\t3\t6\n", "test.lvm");
  EXPECT_THAT(other.table.columns[0].values, ElementsAre(1, 2));
  EXPECT_THAT(other.notes, ElementsAre("1 of 2 segments have other channels or another Delta_X: left out"));
}

TEST(LabviewFile, SpecialBlocksAndChannelsWithoutHeadersAreUnderstood) {
  const auto read = parseLabviewFile(
      "LabVIEW Measurement\n***Start_Special***\nX_Columns\tMulti\n***End_Special***\nX_Columns\tOne\n"
      "***End_of_Header***\n\nX_Value\tbox\tComment\n0\t1\n0.5\t2\n",
      "test.lvm");
  ASSERT_EQ(read.table.columns.size(), 2);
  EXPECT_EQ(read.table.columns[1].name, "box");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0, 0.5));
}

TEST(LabviewFile, MissingValuesAndTextAreNotANumber) {
  const auto read =
      parseLabviewFile(lvmHead("No") + lvmTwoChannels("0", "0.5") + "\t1\t4\n\t\tover\n\tNaN\t6\n\t2", "test.lvm");
  const double nan = std::nan("");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1, NanSensitiveDoubleEq(nan), NanSensitiveDoubleEq(nan)));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(4, NanSensitiveDoubleEq(nan), 6));
  EXPECT_EQ(read.table.columns[1].badRow, 1);
  EXPECT_EQ(read.table.columns[1].badText, "'over'");
  EXPECT_THAT(read.notes, ElementsAre("the last row is cut short: left out"));
}

TEST(LabviewFile, ARateOfFewDigitsIsNoted) {
  const auto read = parseLabviewFile(lvmHead("No") + lvmTwoChannels("0", "0.000020") + "\t1\t4\n\t2\t5\n", "test.lvm");
  EXPECT_THAT(read.rate, DoubleNear(50000, 1e-6));
  EXPECT_THAT(read.notes, ElementsAre("Delta_X is written as 0.000020: the sampling rate may be off by 2.5 %"));
  const auto none = parseLabviewFile(lvmHead("No") + lvmTwoChannels("0", "") + "\t1\t4\n\t2\t5\n", "test.lvm");
  EXPECT_EQ(none.rate, 0);
  EXPECT_THAT(none.notes, ElementsAre("the file states no Delta_X: give the sampling rate"));
}

TEST(LabviewFile, IsReadFromItsPath) {
  const std::string path = testing::TempDir() + "squat-loggers-" + std::to_string(::getpid()) + ".lvm";
  std::ofstream(path, std::ios::binary) << lvmHead("No") + lvmTwoChannels("0", "0.5") + "\t1\t4\n";
  const auto read = readLabviewFile(path);
  std::filesystem::remove(path);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1));
  EXPECT_EQ(read.table.path, path);
  EXPECT_THROW(readLabviewFile(path), FileError);
}

TEST(LabviewFile, DamageIsNamed) {
  EXPECT_THAT(lvmError("LabVIEW Measurement\nSeparator\tTab\n"), HasSubstr("ends before its header does"));
  EXPECT_THAT(lvmError(lvmHead("No")), HasSubstr("has no rows of numbers"));
  EXPECT_THAT(lvmError(lvmHead("No") + "Channels\t2\nX0\t0\n"), HasSubstr("has no row of names"));
  EXPECT_THAT(lvmError(lvmHead("No") + "Channels\t3\nX_Value\ta\tComment\n\t1\n"),
              HasSubstr("line 15: names 2 channels where 3 are stated"));
  EXPECT_THAT(lvmError(lvmHead("No") + "Channels\tx\nX_Value\ta\n\t1\n"), HasSubstr("states 'x' channels"));
  EXPECT_THAT(lvmError(lvmHead("No") + "X_Value\tComment\n\t1\n"), HasSubstr("has no channels"));
  EXPECT_THAT(lvmError(lvmHead("No") + lvmTwoChannels("0", "1")), HasSubstr("has no rows of numbers"));
  // Many columns in the header, and rows of one field: the table would be far larger than its file.
  std::string wide = lvmHead("No") + "X_Value";
  for (int i = 0; i < 5000; ++i) wide += "\ta";
  for (int i = 0; i < 5000; ++i) wide += "\n\t1";
  EXPECT_THAT(lvmError(wide), HasSubstr("has fewer fields than there are channels"));
}

}  // namespace
}  // namespace squat::loggers
