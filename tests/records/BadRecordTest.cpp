// What goes wrong in long records: each fault is reported with its place, and the rest is read.
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

constexpr double rate = 10000, speed = 20;

struct Row {
  double time, position;
  std::string left, right;
};

// 4000 rows of two channels at 20 m/s and 10 kHz from km 5 on; `change` spoils some. Row i stands in line i + 2.
std::string spoilt(const std::function<void(std::size_t, Row&)>& change) {
  std::string text = "time [s],position [m],left,right\n";
  for (std::size_t i = 0; i < 4000; ++i) {
    Row row{static_cast<double>(i) / rate, 5000 + speed * static_cast<double>(i) / rate, std::to_string(i % 13),
            std::to_string(i % 17)};
    change(i, row);
    char axes[64];
    std::snprintf(axes, sizeof axes, "%.4f,%.3f,", row.time, row.position);
    text += axes + row.left + "," + row.right + "\n";
  }
  return text;
}

WholeRecord read(const std::string& content, std::size_t blockLength = 500) {
  const TemporaryFile file(content);
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.blockLength = blockLength;
  return readWhole(file.path(), options);
}

TEST(BadRecord, aGoodOneHasNoFault) {
  const auto whole = read(spoilt([](std::size_t, Row&) {}));
  EXPECT_THAT(whole.faults, IsEmpty());
  EXPECT_EQ(whole.stretches.size(), 1u);
  EXPECT_NEAR(whole.stretches[0].speed[2000], speed, 1e-6);
}

TEST(BadRecord, aGapInTimePartsIt) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 1500) row.time += 0.2, row.position += 4;
  }));
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].kind, FaultKind::gap);
  EXPECT_EQ(whole.faults[0].first, 1500u);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("line 1502: a gap of 200 ms"));
  EXPECT_NEAR(whole.faults[0].time, 0.35, 1e-9);
  EXPECT_NEAR(whole.faults[0].position, 5007, 1e-9);
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_EQ(whole.stretches[0].size(), 1500u);
  EXPECT_EQ(whole.stretches[1].size(), 2500u);
  EXPECT_NEAR(whole.stretches[1].time, 0.35, 1e-9);
}

TEST(BadRecord, oneMissingSampleIsAGap) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 1500) row.time += 1 / rate;
  }));
  ASSERT_EQ(whole.faultsOf(FaultKind::gap).size(), 1u);
  EXPECT_EQ(whole.stretches.size(), 2u);
}

TEST(BadRecord, timeThatGoesBack) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 1000) row.time -= 0.05;
  }));
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("goes back by 50"));
}

TEST(BadRecord, rowsWithoutNumbers) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 1400 && i < 1410) row.left = "NaN", row.right = "";
  }));
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].kind, FaultKind::notANumber);
  EXPECT_EQ(whole.faults[0].first, 1400u);
  EXPECT_EQ(whole.faults[0].end, 1410u);
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_EQ(whole.stretches[1].first, 1410u);
  EXPECT_EQ(whole.stretches[1].values[0][0], 1410 % 13);
}

TEST(BadRecord, oneChannelWithoutNumbersLeavesTheOtherAlone) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 900 && i < 2100) row.right = "-";
  }));
  ASSERT_EQ(whole.stretches.size(), 1u);
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].channel, 1);
  EXPECT_EQ(whole.faults[0].first, 900u);
  EXPECT_EQ(whole.faults[0].end, 2100u);
  EXPECT_EQ(whole.stretches[0].values[0][1500], 1500 % 13);
  for (const double value : whole.stretches[0].values[1]) ASSERT_TRUE(std::isfinite(value));
}

TEST(BadRecord, aLineWithOtherFieldsIsReportedAndLeftOut) {
  auto content = spoilt([](std::size_t, Row&) {});
  const auto at = content.find("0.2000,");
  content.insert(at, "restarted by the operator\n");
  const auto whole = read(content);
  ASSERT_GE(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].kind, FaultKind::notANumber);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("line 2002"));
}

TEST(BadRecord, aPartWithAnotherRate) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    const double extra = i < 1500 ? 0 : i < 2500 ? static_cast<double>(i - 1500) / rate : 1000 / rate;
    row.time += extra;
    row.position += speed * extra;
  }));
  const auto changes = whole.faultsOf(FaultKind::rateChange);
  ASSERT_EQ(changes.size(), 1u);
  // The first sample a step late is the one after 1500; it ends within the window of 64 rows that tells a rate.
  EXPECT_NEAR(static_cast<double>(changes[0].first), 1501, 1);
  EXPECT_NEAR(static_cast<double>(changes[0].end), 2500, 64);
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_EQ(whole.stretches[0].size() + whole.stretches[1].size(), 4000 - (changes[0].end - changes[0].first));
  EXPECT_EQ(whole.layout.rate, rate);
}

// More than half of the steps are the others: the rate is that of the beginning all the same.
TEST(BadRecord, aSecondHalfWithAnotherRateIsCutOff) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
                            const double extra = i < 1800 ? 0 : static_cast<double>(i - 1800) / rate;
                            row.time += extra;
                            row.position += speed * extra;
                          }),
                          4000);
  EXPECT_EQ(whole.layout.rate, rate);
  const auto changes = whole.faultsOf(FaultKind::rateChange);
  ASSERT_EQ(changes.size(), 1u);
  // The first sample that is a step late.
  EXPECT_EQ(changes[0].first, 1801u);
  EXPECT_EQ(changes[0].end, 4000u);
  ASSERT_EQ(whole.stretches.size(), 1u);
  EXPECT_EQ(whole.stretches[0].size(), changes[0].first);
}

TEST(BadRecord, aPositionThatJumps) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 2500) row.position += 150;
  }));
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].kind, FaultKind::positionJump);
  EXPECT_EQ(whole.faults[0].first, 2500u);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("jumps by 150 m"));
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_NEAR(whole.stretches[1].position[0], 5155, 1e-9);
}

TEST(BadRecord, aPositionThatGoesBack) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i >= 2000) row.position -= 3;
  }));
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("goes back by"));
  ASSERT_EQ(whole.stretches.size(), 2u);
  // Read again 2 m behind the lowest position: 1000 rows of 2 mm.
  EXPECT_EQ(whole.stretches[1].first, 3000u);
}

TEST(BadRecord, aLastLineThatIsCutOff) {
  auto content = spoilt([](std::size_t, Row&) {});
  content.resize(content.size() - 6);
  const auto whole = read(content);
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].kind, FaultKind::truncated);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("line 4001"));
  EXPECT_EQ(whole.stretches[0].size(), 3999u);
}

TEST(BadRecord, unitsThatAreNoAcceleration) {
  std::string unknown = "time [s],box [mm]\n", unstated = "time [s],box\n";
  for (int i = 0; i < 300; ++i) {
    unknown += std::to_string(i) + "e-4,1\n";
    unstated += std::to_string(i) + "e-4,1\n";
  }
  RecordOptions options;
  options.columns.speed = 30;
  EXPECT_THAT(complaintAbout(TemporaryFile(unknown).path(), options), HasSubstr("'box' is in mm, which is no acc"));
  EXPECT_THAT(complaintAbout(TemporaryFile(unstated).path(), options), HasSubstr("'box' states no unit"));
  options.columns.signalUnit = "g";
  const TemporaryFile file(unstated);
  EXPECT_DOUBLE_EQ(readWhole(file.path(), options).stretches[0].values[0][7], 9.80665);
}

TEST(BadRecord, valuesThatLookLikeAnotherUnit) {
  const auto notes = [](const char* header, double mean, double amplitude = 0.3) {
    std::string content = header;
    for (int i = 0; i < 300; ++i)
      content += std::to_string(i) + "e-4," + std::to_string(mean + (i % 2 ? amplitude : -amplitude)) + "\n";
    const TemporaryFile file(content);
    RecordOptions options;
    options.columns.signalUnit = "m/s2";
    options.columns.speed = 30;
    return readWhole(file.path(), options).layout.notes;
  };
  EXPECT_THAT(notes("time [s],aba [m/s2]\n", 1.0), ::testing::Contains(HasSubstr("as gravity has in g")));
  EXPECT_THAT(notes("time [s],aba [g]\n", 9.8), ::testing::Contains(HasSubstr("as gravity has in m/s2")));
  EXPECT_THAT(notes("time [s],aba [m/s2]\n", 50.0), IsEmpty());
  // 300 values of 30 m/s2: their mean is known to 1.7 m/s2 and says nothing about gravity.
  EXPECT_THAT(notes("time [s],aba [m/s2]\n", 1.0, 30), IsEmpty());
}

TEST(BadRecord, swappedCoordinatesAndAxes) {
  std::string content = "time,lat,lon,aba\n";
  for (int i = 0; i < 300; ++i) content += std::to_string(i) + "e-4,115.1,-32.0,1\n";
  const TemporaryFile file(content);
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = 30;
  const auto whole = readWhole(file.path(), options);
  EXPECT_FALSE(whole.layout.hasCoordinates);
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_THAT(whole.faults[0].advice, HasSubstr("swapped"));
  std::string swapped = "time,position,aba\n";
  for (int i = 0; i < 300; ++i) swapped += std::to_string(10000 - 2 * i) + "," + std::to_string(i) + "e-4,1\n";
  EXPECT_THAT(complaintAbout(TemporaryFile(swapped).path(), options), HasSubstr("swapped"));
}

TEST(BadRecord, thousandsOfFaultsStayAShortList) {
  const auto whole = read(spoilt([](std::size_t i, Row& row) {
    if (i % 3 == 0) row.left = row.right = "x";
  }));
  EXPECT_LE(whole.faults.size(), 1000u);
  EXPECT_THAT(whole.faults.back().text, HasSubstr("more of this kind"));
  EXPECT_GE(whole.faults.back().end, 3998u);
}

}  // namespace
}  // namespace squat::records
