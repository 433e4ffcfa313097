// Long records from text made by hand: every dialect, and where positions, speeds and coordinates come from.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::TemporaryFile;

double aba(std::size_t i) { return std::round(1000 * std::sin(0.3 * static_cast<double>(i))) / 10; }

std::string printed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// A header, then what `row` says of each sample.
std::string table(const std::string& header, std::size_t rows, const std::function<std::string(std::size_t)>& row) {
  std::string text = header.empty() ? "" : header + "\n";
  for (std::size_t i = 0; i < rows; ++i) text += row(i) + "\n";
  return text;
}

RecordOptions atSpeed(double speed) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = speed;
  return options;
}

TEST(TextRecord, oneChannelAtConstantSpeed) {
  const TemporaryFile file(table("time [s],aba [m/s2]", 1000, [](std::size_t i) {
    return printed(static_cast<double>(i) / 25000, 5) + "," + printed(aba(i), 1);
  }));
  auto options = atSpeed(30);
  options.chainage = 12345.6;
  options.blockLength = 64;
  const auto whole = readWhole(file.path(), options);
  EXPECT_THAT(whole.faults, IsEmpty());
  ASSERT_EQ(whole.stretches.size(), 1u);
  EXPECT_EQ(whole.layout.rate, 25000);  // a whole number within what the digits allow
  EXPECT_FALSE(whole.layout.hasPosition);
  ASSERT_EQ(whole.stretches[0].size(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_EQ(whole.stretches[0].values[0][i], aba(i));
  EXPECT_EQ(whole.stretches[0].speed[500], 30);
  // Constant speed: the way is speed times time; times are written to 1e-5 s, at 30 m/s 0.3 mm.
  EXPECT_NEAR(whole.stretches[0].position[999], 12345.6 + 30 * 999 / 25000.0, 3e-4);
}

TEST(TextRecord, dialectsGiveTheSameRecord) {
  const auto rows = [](const char* format) {
    return [format](std::size_t i) {
      char text[128];
      std::snprintf(text, sizeof text, format, 3 * i, std::lround(10 * std::abs(aba(i))) / 10,
                    std::lround(10 * std::abs(aba(i))) % 10, 30);
      return std::string(text);
    };
  };
  const std::vector<std::string> contents{
      table("time [ms],aba [m/s2],speed [m/s]", 300, rows("0.%03zu,%ld.%ld,%d")),
      table("time [ms];aba [m/s2];speed [m/s]", 300, rows("0,%03zu;%ld,%ld;%d")),
      "\xEF\xBB\xBF" + table("time [ms]\taba [m/s2]\tspeed [m/s]", 300, rows("0.%03zu\t%ld.%ld\t%d\r")),
      table("recorded by hand\n# 300 rows\ntime | aba | speed\nms | m/s2 | m/s", 300, rows("0.%03zu | %ld.%ld | %d")),
      table("time[ms] aba[m/s2] speed[m/s]", 300, rows("  0.%03zu   %ld.%ld %d ")),
      table("\"time [ms]\",\"aba [m/s2]\",\"speed [m/s]\"", 300, rows("\"0.%03zu\",\"%ld.%ld\",%d")),
      table("time [ms];aba [m/s2];speed [m/s];", 300, rows("0.%03zu;%ld.%ld;%d;"))};
  for (const auto& content : contents) {
    const TemporaryFile file(content);
    const auto whole = readWhole(file.path());
    SCOPED_TRACE(content.substr(0, 60));
    ASSERT_EQ(whole.stretches.size(), 1u);
    EXPECT_THAT(whole.faults, IsEmpty());
    EXPECT_EQ(whole.layout.channels[0].name, "aba");
    EXPECT_NEAR(whole.layout.rate, 1e6 / 3, 0.1);  // 3 us a row
    ASSERT_EQ(whole.stretches[0].size(), 300u);
    for (std::size_t i = 0; i < 300; ++i) ASSERT_DOUBLE_EQ(whole.stretches[0].values[0][i], std::abs(aba(i)));
    EXPECT_EQ(whole.stretches[0].speed[7], 30);
  }
}

TEST(TextRecord, allAxleBoxesAndNothingElse) {
  const TemporaryFile file(table("t [s];left [g];right [g];temperature [K];trailing left", 200, [](std::size_t i) {
    const auto t = printed(static_cast<double>(i) / 10000, 4);
    return t + ";1;2;290;" + printed(static_cast<double>(i % 7), 0);
  }));
  const auto whole = readWhole(file.path(), atSpeed(20));
  ASSERT_EQ(whole.layout.channels.size(), 3u);
  EXPECT_EQ(whole.layout.channels[1].name, "right");
  EXPECT_EQ(whole.layout.channels[2].unit, "m/s2");
  EXPECT_DOUBLE_EQ(whole.stretches[0].values[1][3], 2 * 9.80665);
  EXPECT_THAT(whole.layout.notes, ::testing::Contains(HasSubstr("4 temperature")));
  auto options = atSpeed(20);
  options.columns.column = "right, 2";
  EXPECT_EQ(readWhole(file.path(), options).layout.channels[1].name, "left");
  options.columns.column = "abba";
  EXPECT_THAT(complaintAbout(file.path(), options), HasSubstr("no column 'abba'"));
}

TEST(TextRecord, chainageInKilometresAndMetresFalls) {
  const TemporaryFile file(table("km;aba_left;aba_right", 2000, [](std::size_t i) {
    const double metres = 345.6 - 0.01 * static_cast<double>(i);  // 25 m/s at 2500 Hz
    return "12+" + printed(metres, 2) + ";1;2";
  }));
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.rate = 2500;
  options.blockLength = 333;
  const auto whole = readWhole(file.path(), options);
  EXPECT_TRUE(whole.layout.falling);
  EXPECT_TRUE(whole.layout.hasPosition);
  ASSERT_EQ(whole.stretches.size(), 1u);
  EXPECT_NEAR(whole.stretches[0].position[0], 12345.6, 1e-9);
  EXPECT_NEAR(whole.stretches[0].position[1999], 12345.6 - 19.99, 1e-9);
  for (const double speed : whole.stretches[0].speed) ASSERT_NEAR(speed, 25, 1e-6);
}

// A counter that counts quarter metres, and a fix of the coordinates each tenth of a second.
TEST(TextRecord, coarsePositionsAreSpread) {
  const auto at = [](std::size_t i) { return 30 * static_cast<double>(i) / 5000; };
  const TemporaryFile file(table("time,position [m],lat,lon,aba", 5000, [&](std::size_t i) {
    const double fix = at(i / 500 * 500);
    return printed(static_cast<double>(i) / 5000, 4) + "," + printed(1000 + std::floor(4 * at(i)) / 4, 2) + "," +
           printed(52 + fix * 1e-5, 7) + "," + printed(5 + fix * 1e-5, 7) + (i % 2 ? ",1" : ",2");
  }));
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.blockLength = 700;
  const auto whole = readWhole(file.path(), options);
  ASSERT_EQ(whole.stretches.size(), 1u);
  EXPECT_THAT(whole.faults, IsEmpty());
  ASSERT_EQ(whole.stretches[0].size(), 5000u);
  for (std::size_t i = 0; i < 5000; ++i) {
    ASSERT_NEAR(whole.stretches[0].position[i], 1000 + at(i), 0.25) << i;  // what the counter counts
    ASSERT_NEAR(whole.stretches[0].speed[i], 30, 1.5) << i;  // a quarter metre in the 5 m of half a second: 5 %
    ASSERT_NEAR(whole.stretches[0].latitude[i], 52 + at(i) * 1e-5, 3.1e-5) << i;  // the way between two fixes
  }
  for (std::size_t i = 1; i < 5000; ++i)
    ASSERT_GE(whole.stretches[0].position[i], whole.stretches[0].position[i - 1]) << i;
}

// Times with so few digits that steps differ or repeat are no change of rate.
TEST(TextRecord, roundedTimes) {
  for (const int digits : {7, 5, 4, 3}) {
    const TemporaryFile file(table("time,aba", 60000, [&](std::size_t i) {
      return printed(static_cast<double>(i) / 12800, digits) + "," + printed(aba(i), 1);
    }));
    auto options = atSpeed(30);
    options.blockLength = 5000;
    const auto whole = readWhole(file.path(), options);
    EXPECT_THAT(whole.faults, IsEmpty()) << digits;
    ASSERT_EQ(whole.stretches.size(), 1u) << digits;
    // The first block tells the rate: its length, known to the resolution of the times.
    EXPECT_NEAR(whole.layout.rate / 12800, 1, 2 * std::pow(10, -digits) / (5000 / 12800.0)) << digits;
  }
}

TEST(TextRecord, withoutHeaderAndWithoutTime) {
  const TemporaryFile two(table(
      "", 100, [](std::size_t i) { return printed(static_cast<double>(i) / 1000, 3) + "," + printed(aba(i), 1); }));
  EXPECT_EQ(readWhole(two.path(), atSpeed(10)).layout.rate, 1000);
  const TemporaryFile one(table("", 100, [](std::size_t i) { return printed(aba(i), 1); }));
  EXPECT_THAT(complaintAbout(one.path(), atSpeed(10)), HasSubstr("Give the rate"));
  auto options = atSpeed(10);
  options.columns.rate = 500;
  const auto whole = readWhole(one.path(), options);
  EXPECT_EQ(whole.stretches[0].size(), 100u);
  EXPECT_NEAR(whole.stretches[0].position[50], 1, 1e-12);
  options.columns.speed = 0;
  EXPECT_THAT(complaintAbout(one.path(), options), HasSubstr("give the speed"));
}

TEST(TextRecord, whatIsNoRecord) {
  EXPECT_THAT(complaintAbout("/nowhere/at/all.csv", atSpeed(1)), HasSubstr("is not there"));
  for (const char* content : {"", "no table\n", "time,aba\n", "\xFF\xFE\x31\x00", "time,aba\n0,1\n"})
    EXPECT_NE(complaintAbout(TemporaryFile(content).path(), atSpeed(1)), "") << content;
}

}  // namespace
}  // namespace squat::records
