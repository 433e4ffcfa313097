// What is shown of a file is what its heading and rows, written here, say.
#include "records/Inspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "readers/TemporaryFile.h"

namespace squat::records {
namespace {

using testing::Contains;
using testing::HasSubstr;

// 4000 rows at 5 kHz, in ms and g.
std::string inspectedText(const char* heading) {
  std::string text = heading;
  for (int i = 0; i < 4000; ++i) {
    char row[80];
    std::snprintf(row, sizeof row, "%.1f;%.4f;%d\n", 0.2 * i, 8 * std::sin(0.4 * i), i);
    text += row;
  }
  return text;
}

Inspection inspected(const std::string& text, double speed) {
  const tests::TemporaryFile file(text);
  RecordOptions options;
  options.everyAcceleration = true;
  options.columns.speed = speed;
  Monitor monitor;
  return inspectRecord(file.path(), options, monitor);
}

TEST(Inspection, ShowsColumnsRateAndWay) {
  const auto seen = inspected(inspectedText("logger 7\ntime [ms];box [g];count\n"), 30);
  EXPECT_EQ(seen.refusal, "");
  EXPECT_THAT(seen.structure, HasSubstr("numbers from line 3"));
  ASSERT_EQ(seen.columns.size(), 3u);
  EXPECT_EQ(seen.columns[0].use, "time");
  EXPECT_EQ(seen.columns[0].unit, "ms");
  EXPECT_EQ(seen.columns[1].use, "signal");
  EXPECT_EQ(seen.columns[2].use, "passed over");
  ASSERT_GE(seen.columns[0].first.size(), 2u);
  EXPECT_EQ(seen.columns[0].first[1], 0.2) << "as the file has it";
  ASSERT_TRUE(seen.layout);
  EXPECT_EQ(seen.layout->rate, 5000);
  EXPECT_EQ(seen.read, 4000u);
  EXPECT_NEAR(seen.duration, 0.8, 1e-12);
  ASSERT_TRUE(seen.way);
  EXPECT_NEAR(*seen.way, 24, 1e-9);  // 30 m/s over 4000 steps of 0.2 ms
}

TEST(Inspection, NeedsNoSpeed) {
  const auto seen = inspected(inspectedText("time [ms];box [g];count\n"), 0);
  EXPECT_EQ(seen.refusal, "");
  EXPECT_FALSE(seen.way);
  EXPECT_EQ(seen.layout->rate, 5000);
  EXPECT_THAT(seen.doubts, Contains(HasSubstr("--speed")));
}

TEST(Inspection, ShowsTheColumnsOfWhatIsRefused) {
  const auto seen = inspected(inspectedText("time [ms];box;count\n"), 30);
  EXPECT_THAT(seen.refusal, HasSubstr("'box' states no unit"));
  EXPECT_EQ(seen.columns.size(), 3u);
  EXPECT_FALSE(seen.layout);
}

}  // namespace
}  // namespace squat::records
