// Universal files, made after SDRC's description of dataset 58 and the University of Cincinnati's of 58b: columns and
// widths of the fields are written here by hand.
#include "loggers/UniversalFile.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string uffMark = "    -1\n";

struct UffSet {
  std::string title = "NONE";
  int type = 1, node = 12, direction = 3;
  int kind = 2, count = 0, spacing = 1;
  std::string step = "  9.76563E-04", start = "  0.00000E+00";
  int abscissa = 17, ordinate = 12, denominator = 0;
  std::string abscissaUnit = "NONE", ordinateUnit = "NONE", denominatorUnit = "NONE";
};

std::string uffCharacteristics(int code, const std::string& unit) {
  char line[96];
  std::snprintf(line, sizeof line, "%10d%5d%5d%5d %-20s %-20s\n", code, 0, 0, 0, "NONE", unit.c_str());
  return line;
}

std::string uffHead(const UffSet& set) {
  char points[96], shape[96];
  std::snprintf(points, sizeof points, "%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d\n", set.type, 0, 0, 0, "NONE",
                set.node, set.direction, "NONE", 1, -1);
  std::snprintf(shape, sizeof shape, "%10d%10d%10d%13s%13s  0.00000E+00\n", set.kind, set.count, set.spacing,
                set.start.c_str(), set.step.c_str());
  return set.title + "\nNONE\n27-Nov-26 09:30:00\nNONE\nNONE\n" + points + shape +
         uffCharacteristics(set.abscissa, set.abscissaUnit) + uffCharacteristics(set.ordinate, set.ordinateUnit) +
         uffCharacteristics(set.denominator, set.denominatorUnit) + uffCharacteristics(0, "NONE");
}

std::string uffText58(const UffSet& set, const std::string& values) {
  return uffMark + "    58\n" + uffHead(set) + values + uffMark;
}

std::string uffBytes(std::uint64_t value, int size, bool big) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * (big ? size - 1 - i : i)) & 0xFF);
  return bytes;
}

std::string uffSingle(float value, bool big) { return uffBytes(std::bit_cast<std::uint32_t>(value), 4, big); }
std::string uffDouble(double value, bool big) { return uffBytes(std::bit_cast<std::uint64_t>(value), 8, big); }

std::string uffBinary58(const UffSet& set, const std::string& values, int order, int format = 2,
                        const std::string& behind = "") {
  char name[96];
  std::snprintf(name, sizeof name, "    58b%6d%6d%12d%12d%6d%6d%12d%12d\n", order, format, 11,
                static_cast<int>(values.size()), 0, 0, 0, 0);
  return uffMark + name + uffHead(set) + values + behind + uffMark;
}

std::string uffError(const std::string& bytes) {
  try {
    parseUniversalFile(bytes, "test.unv");
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(UniversalFile, IsKnownByItsFirstLines) {
  EXPECT_TRUE(isUniversalFile("    -1\n    58\nNONE\n"));
  EXPECT_TRUE(isUniversalFile("\r\n    -1      \r\n   151\r\n"));
  EXPECT_TRUE(isUniversalFile("    -1\n    58b     1     2          11        4096\n"));
  EXPECT_FALSE(isUniversalFile("    -1\n"));
  EXPECT_FALSE(isUniversalFile("-1\n58\n60\n"));
  EXPECT_FALSE(isUniversalFile("    -1\n    58    12\n"));
  EXPECT_FALSE(isUniversalFile("    -1\n   -58\n"));
  EXPECT_THAT(uffError("t,a\n0,1\n"), HasSubstr("is not a universal file"));
}

TEST(UniversalFile, TimeHistoriesOfOneLengthAreColumns) {
  UffSet left, right;
  left.count = right.count = 7;
  left.title = "left box";
  right.title = "right box";
  right.ordinateUnit = "g";
  const auto read = parseUniversalFile(
      uffText58(left,
                "  1.00000E+00 -2.00000E+00  3.50000E+00  4.00000E+00  5.00000E+00  6.00000E+00\n  7.00000E-03\n") +
          uffText58(right,
                    " -1.00000E+00 -1.00000E+00 -1.00000E+00 -1.00000E+00 -1.00000E+00 -1.00000E+00\n"
                    "  2.50000E+02\n"),
      "test.unv");
  // 9.76563E-04 s is 1/1024 s in six digits.
  EXPECT_EQ(read.rate, 1024);
  EXPECT_THAT(read.notes, ElementsAre("the time step 9.76563E-04 s is taken for a sampling rate of 1024 Hz"));
  ASSERT_THAT(read.table.columns, SizeIs(2));
  EXPECT_EQ(read.table.columns[0].name, "left box");
  EXPECT_EQ(read.table.columns[0].unit, "m/s2");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1, -2, 3.5, 4, 5, 6, 0.007));
  EXPECT_EQ(read.table.columns[1].unit, "g");
  EXPECT_EQ(read.table.columns[1].values[6], 250);
  EXPECT_THAT(read.table.lines, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(read.table.rowWord, "sample");
}

TEST(UniversalFile, RatesAreWhatTheirDigitsAllow) {
  const auto rate = [](const char* step) {
    UffSet set;
    set.count = 1;
    set.step = step;
    return parseUniversalFile(uffText58(set, "  1.00000E+00\n"), "test.unv").rate;
  };
  EXPECT_EQ(rate("  1.95313E-05"), 51200);                 // 1/51200 = 1.953125E-05
  EXPECT_EQ(rate("  3.81470E-06"), 262144);                // 1/262144 = 3.8147E-06
  EXPECT_EQ(rate("  3.90625E-05"), 25600);                 // exactly
  EXPECT_DOUBLE_EQ(rate("1.9531000E-05"), 1 / 1.9531e-5);  // eight digits leave nothing open near 51200
  EXPECT_DOUBLE_EQ(rate("  5.00000E-01"), 2);
}

TEST(UniversalFile, FieldsThatTouchAreCutByTheirWidth) {
  UffSet set;
  set.count = 4;
  set.step = "  5.00000E-01";
  // 6E13.6: nothing is left between the fields.
  EXPECT_THAT(parseUniversalFile(uffText58(set, "-1.000000E+00-2.000000E+01-3.000000E+02 4.000000E-03\n"), "t")
                  .table.columns[0]
                  .values,
              ElementsAre(-1, -20, -300, 0.004));
  // Whole numbers that fill their fields.
  EXPECT_THAT(parseUniversalFile(uffText58(set, "12345678901231234567890123            3            4\n"), "t")
                  .table.columns[0]
                  .values,
              ElementsAre(1234567890123, 1234567890123, 3, 4));
  // Fields of another width than the format says are parted by their blanks.
  EXPECT_THAT(
      parseUniversalFile(uffText58(set, "  1.000000000000E+00  2.000000000000E+00\n  3.0\n  4.000000000000E+00\n"), "t")
          .table.columns[0]
          .values,
      ElementsAre(1, 2, 3, 4));
  // Doubles: 4E20.12 with exponents of three digits, with D, and without a letter.
  set.kind = 4;
  EXPECT_THAT(parseUniversalFile(uffText58(set,
                                           "-1.5000000000000E+00-2.5000000000000D+01 3.000000000000E+100"
                                           "  4.000000000000-100\n"),
                                 "t")
                  .table.columns[0]
                  .values,
              ElementsAre(-1.5, -25, 3e100, 4e-100));
}

TEST(UniversalFile, AnUnevenTimeIsAColumn) {
  UffSet set;
  set.spacing = 0;
  set.count = 3;
  set.abscissaUnit = "ms";
  const auto single = parseUniversalFile(
      uffText58(set, "  0.00000E+00  1.00000E+00  5.00000E+02  2.00000E+00  7.50000E+02  3.00000E+00\n"), "t");
  EXPECT_EQ(single.rate, 0);
  ASSERT_THAT(single.table.columns, SizeIs(2));
  EXPECT_EQ(single.table.columns[0].name, "time");
  EXPECT_EQ(single.table.columns[0].unit, "s");
  EXPECT_THAT(single.table.columns[0].values, ElementsAre(0, 0.5, 0.75));
  EXPECT_THAT(single.table.columns[1].values, ElementsAre(1, 2, 3));
  // 2(E13.5,E20.12), filled to the width of the fields.
  set.kind = 4;
  const auto twice = parseUniversalFile(uffText58(set,
                                                  "-1.000000E+00-1.0000000000000E+00 5.000000E+02-2.5000000000000E+00\n"
                                                  "  7.50000E+02  3.000000000000E+00\n"),
                                        "t");
  EXPECT_THAT(twice.table.columns[0].values, ElementsAre(-0.001, 0.5, 0.75));
  EXPECT_THAT(twice.table.columns[1].values, ElementsAre(-1, -2.5, 3));
}

TEST(UniversalFile, BinaryInBothOrdersOfBytes) {
  for (const bool big : {false, true})
    for (const int kind : {2, 4})
      for (const char* behind : {"", "\n", "\r\n"}) {
        UffSet set;
        set.count = 3;
        set.kind = kind;
        set.step = "  5.00000E-01";
        std::string values;
        for (const float value : {1.5F, -2.25F, 0.0F})
          values += kind == 2 ? uffSingle(value, big) : uffDouble(static_cast<double>(value), big);
        const std::string one = uffBinary58(set, values, big ? 2 : 1, 2, behind);
        const auto read = parseUniversalFile(one + one, "t");
        EXPECT_EQ(read.rate, 2);
        ASSERT_THAT(read.table.columns, SizeIs(2));
        EXPECT_THAT(read.table.columns[1].values, ElementsAre(1.5, -2.25, 0));
        EXPECT_THAT(read.notes, IsEmpty());
      }
}

TEST(UniversalFile, BytesThatLookLikeTheEndAreValues) {
  UffSet set;
  set.count = 3;
  const std::string text = "\n    -1\n    ";  // 12 bytes
  const auto read = parseUniversalFile(uffBinary58(set, text, 1), "t");
  ASSERT_EQ(read.table.rows(), 3);
  EXPECT_EQ(static_cast<float>(read.table.columns[0].values[2]), std::bit_cast<float>(0x20202020U));
}

TEST(UniversalFile, AnUnevenAbscissaInBytesIsSingleOrDouble) {
  UffSet set;
  set.count = 2;
  set.kind = 4;
  set.spacing = 0;
  const std::string single = uffSingle(0, true) + uffDouble(1.5, true) + uffSingle(0.5F, true) + uffDouble(2.5, true);
  const std::string twice = uffDouble(0, true) + uffDouble(1.5, true) + uffDouble(0.5, true) + uffDouble(2.5, true);
  for (const auto& values : {single, twice}) {
    const auto read = parseUniversalFile(uffBinary58(set, values, 2), "t");
    EXPECT_THAT(read.table.columns[0].values, ElementsAre(0, 0.5));
    EXPECT_THAT(read.table.columns[1].values, ElementsAre(1.5, 2.5));
  }
}

TEST(UniversalFile, FrequencyResponsesAreRealAndImaginaryParts) {
  UffSet set;
  set.type = 4;
  set.kind = 5;
  set.count = 2;
  set.start = "  1.00000E+01";
  set.step = "  5.00000E-01";
  set.abscissa = 18;
  set.denominator = 13;
  const std::string values = "  1.00000E-03 -2.00000E-03  3.00000E-03 -4.00000E-03\n";
  const auto one = parseUniversalFile(uffText58(set, values), "t");
  EXPECT_EQ(one.rate, 0);
  ASSERT_THAT(one.table.columns, SizeIs(3));
  EXPECT_EQ(one.table.columns[0].name, "f");
  EXPECT_EQ(one.table.columns[0].unit, "Hz");
  EXPECT_THAT(one.table.columns[0].values, ElementsAre(10, 10.5));
  EXPECT_EQ(one.table.columns[1].name, "Re");
  EXPECT_EQ(one.table.columns[1].unit, "m/s2/N");
  EXPECT_THAT(one.table.columns[1].values, ElementsAre(0.001, 0.003));
  EXPECT_EQ(one.table.columns[2].name, "Im");
  EXPECT_THAT(one.table.columns[2].values, ElementsAre(-0.002, -0.004));

  // Two of them, in double precision and in bytes, with labels.
  UffSet other = set;
  other.node = 14;
  other.kind = 6;
  other.ordinateUnit = "m";
  other.denominatorUnit = "kN";
  const auto two = parseUniversalFile(
      uffText58(set, values) +
          uffBinary58(other, uffDouble(1, false) + uffDouble(2, false) + uffDouble(3, false) + uffDouble(4, false), 1),
      "t");
  ASSERT_THAT(two.table.columns, SizeIs(5));
  EXPECT_EQ(two.table.columns[1].name, "12 +Z by 1 -X Re");
  EXPECT_EQ(two.table.columns[4].name, "14 +Z by 1 -X Im");
  EXPECT_EQ(two.table.columns[4].unit, "m/kN");
  EXPECT_THAT(two.table.columns[4].values, ElementsAre(2, 4));

  set.ordinate = 8;
  EXPECT_EQ(parseUniversalFile(uffText58(set, values), "t").table.columns[1].unit, "m/N");
  set.ordinate = 11;
  EXPECT_EQ(parseUniversalFile(uffText58(set, values), "t").table.columns[1].unit, "m/s/N");
  set.ordinateUnit = "m/s^2";
  EXPECT_EQ(parseUniversalFile(uffText58(set, values), "t").table.columns[1].unit, "m/s2/N");
  set.abscissaUnit = "rad/s";
  EXPECT_THAT(parseUniversalFile(uffText58(set, values), "t").table.columns[0].values[0],
              DoubleEq(10 / (2 * std::numbers::pi)));
}

// Units of mm and mN: a value divided by 1000 is in SI.
const std::string uffMillimetres = uffMark +
                                   "   164\n         5mm (milli-newton)            2\n"
                                   "  1.00000000000000000D+03  1.00000000000000000D+03  1.00000000000000000D+00\n"
                                   "  2.73149999999999980D+02\n" +
                                   uffMark;

TEST(UniversalFile, Dataset164StatesTheUnits) {
  UffSet set;
  set.count = 1;
  const auto read = parseUniversalFile(uffMillimetres + uffText58(set, "  2.50000E+03\n"), "t");
  EXPECT_EQ(read.table.columns[0].unit, "m/s2");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(DoubleEq(2.5)));
  set.ordinate = 13;
  EXPECT_THAT(parseUniversalFile(uffMillimetres + uffText58(set, "  2.50000E+03\n"), "t").table.columns[0].values,
              ElementsAre(DoubleEq(2.5)));
  // A label stands above the code and the system of units.
  set.ordinateUnit = "mm/s2";
  const auto label = parseUniversalFile(uffMillimetres + uffText58(set, "  2.50000E+03\n"), "t");
  EXPECT_EQ(label.table.columns[0].unit, "mm/s2");
  EXPECT_THAT(label.table.columns[0].values, ElementsAre(2500));
  // A response in mm per mN is one in m per N.
  UffSet response;
  response.type = 4;
  response.kind = 5;
  response.count = 1;
  response.abscissa = 18;
  response.ordinate = 8;
  response.denominator = 13;
  EXPECT_THAT(parseUniversalFile(uffMillimetres + uffText58(response, "  2.50000E+03  1.00000E+00\n"), "t")
                  .table.columns[1]
                  .values,
              ElementsAre(DoubleEq(2500)));
  EXPECT_THAT(uffError(uffMark + "   164\nx\ny\n" + uffMark), HasSubstr("states no factors of length and force"));
}

TEST(UniversalFile, NamesAreThoseThatTellColumnsApart) {
  UffSet a, b, c;
  a.count = b.count = c.count = 1;
  a.title = b.title = c.title = "Acceleration";
  b.node = 13;
  c.direction = -5;
  const std::string value = "  1.00000E+00\n";
  const auto points = parseUniversalFile(uffText58(a, value) + uffText58(b, value) + uffText58(c, value), "t");
  EXPECT_EQ(points.table.columns[0].name, "12 +Z");
  EXPECT_EQ(points.table.columns[1].name, "13 +Z");
  EXPECT_EQ(points.table.columns[2].name, "12 -RY");
  const auto same = parseUniversalFile(uffText58(a, value) + uffText58(a, value), "t");
  EXPECT_EQ(same.table.columns[0].name, "12 +Z");
  EXPECT_EQ(same.table.columns[1].name, "12 +Z (2)");
}

TEST(UniversalFile, WhatDoesNotFitIsLeftOutWithANote) {
  UffSet set, spectrum, shorter, response;
  set.count = 2;
  set.step = shorter.step = "  5.00000E-01";
  spectrum.type = 2;
  spectrum.count = 1;
  shorter.count = 1;
  response.type = 4;
  response.kind = 5;
  response.count = 1;
  const std::string one = "  1.00000E+00\n", two = "  1.00000E+00  2.00000E+00\n";
  const auto read = parseUniversalFile(uffMark + "   151\nmodel\n        -1\n" + uffMark + uffText58(shorter, one) +
                                           uffText58(set, two) + uffText58(spectrum, one) + uffText58(response, two) +
                                           uffText58(set, two),
                                       "t");
  EXPECT_EQ(read.rate, 2);
  EXPECT_THAT(read.table.columns, SizeIs(2));
  EXPECT_THAT(read.notes, ElementsAre("1 function left out: neither time histories nor frequency responses with values",
                                      "1 function left out: frequency responses beside time histories",
                                      "1 function left out: another length, beginning or step than most have"));
  EXPECT_THAT(uffError(uffText58(spectrum, one)), HasSubstr("holds no time history and no frequency response"));
}

TEST(UniversalFile, IsReadFromItsPath) {
  UffSet set;
  set.count = 1;
  const std::string path = testing::TempDir() + "squat-loggers-" + std::to_string(::getpid()) + ".unv";
  std::ofstream(path, std::ios::binary) << uffText58(set, "  2.50000E+00\n");
  const auto read = readUniversalFile(path);
  std::filesystem::remove(path);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(2.5));
  EXPECT_EQ(read.table.path, path);
  EXPECT_THROW(readUniversalFile(path), FileError);
}

TEST(UniversalFile, DamageIsNamed) {
  UffSet set;
  set.count = 2;
  const std::string two = "  1.00000E+00  2.00000E+00\n", whole = uffText58(set, two);
  // Line 13 would hold the second value.
  EXPECT_THAT(uffError(uffText58(set, "  1.00000E+00\n")), HasSubstr("ends its dataset after 1 of 2 numbers"));
  EXPECT_THAT(uffError(uffText58(set, "  1.00000E+00        apple\n")),
              HasSubstr("line 14: holds a field that is not a number: '1.00000E+00        apple'"));
  EXPECT_THAT(uffError(whole.substr(0, whole.size() - 25)), HasSubstr("dataset 1: ends with the file"));
  EXPECT_THAT(uffError(uffMark + "    58\nNONE\n" + uffMark), HasSubstr("before the header of 11 lines does"));
  // What is whole before the cut is read.
  const auto cut = parseUniversalFile(whole + whole.substr(0, whole.size() - 25), "t");
  EXPECT_THAT(cut.table.columns, SizeIs(1));
  EXPECT_THAT(cut.notes[0], HasSubstr("dataset 2 ends with the file before its values do: left out"));
  const auto more = parseUniversalFile(uffText58(set, two + two), "t");
  EXPECT_THAT(more.table.columns[0].values, ElementsAre(1, 2));
  EXPECT_THAT(more.notes[0], HasSubstr("dataset 1 holds more values than it states"));

  EXPECT_THAT(uffError(uffBinary58(set, "12345678", 1, 1)),
              HasSubstr("holds numbers of DEC's VMS, which are not read"));
  EXPECT_THAT(uffError(uffBinary58(set, "12345678", 1, 3)), HasSubstr("holds numbers of IBM's 5/370"));
  EXPECT_THAT(uffError(uffBinary58(set, "12345678", 7)), HasSubstr("names no order of bytes"));
  EXPECT_THAT(uffError(uffBinary58(set, "1234", 1)), HasSubstr("states 4 bytes, but its 2 values take 8"));
  set.count = 2000000000;
  EXPECT_THAT(uffError(uffText58(set, two)), HasSubstr("ends with the file before its values do"));
  EXPECT_THAT(uffError(uffBinary58(set, "12345678", 1)), HasSubstr("ends with the file before its values do"));
  set.count = -5;
  EXPECT_THAT(uffError(uffText58(set, two)), HasSubstr("states '-5' values"));
  set.count = 2;
  set.kind = 3;
  EXPECT_THAT(uffError(uffText58(set, two)), HasSubstr("names the kind of ordinate '3', must be 2, 4, 5 or 6"));
  set.kind = 2;
  set.step = "  0.00000E+00";
  EXPECT_THAT(uffError(uffText58(set, two)), HasSubstr("states a time step of '0.00000E+00'"));
}

}  // namespace
}  // namespace squat::loggers
