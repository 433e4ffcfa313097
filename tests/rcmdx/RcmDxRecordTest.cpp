// A long record from a recording of RCM-DX: as the search for squats reads it.
#include <gmock/gmock.h>

#include "rcmdx/SampleRecording.h"
#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::SampleRecording;
using tests::TemporaryFile;

TEST(RcmDxRecord, isReadInPiecesWithItsRateAndPositions) {
  const TemporaryFile file("", ".rcmdx");
  SampleRecording sample;
  sample.withCoordinates = true;
  sample.write(file.path());
  RecordOptions options;
  options.blockLength = 30000;
  const auto whole = readWhole(file.path(), options);
  EXPECT_THAT(whole.faults, IsEmpty());
  EXPECT_EQ(whole.layout.rate, 25000);
  EXPECT_EQ(whole.layout.samples, SampleRecording::samples);
  EXPECT_TRUE(whole.layout.hasPosition);
  EXPECT_TRUE(whole.layout.falling);
  EXPECT_TRUE(whole.layout.hasCoordinates);
  ASSERT_EQ(whole.layout.channels.size(), 2u);
  EXPECT_EQ(whole.layout.channels[0].name, "ABA_LEFT");
  EXPECT_EQ(whole.layout.channels[0].unit, "m/s2");
  ASSERT_EQ(whole.stretches.size(), 1u);
  const auto& all = whole.stretches[0];
  ASSERT_EQ(all.size(), SampleRecording::samples);
  for (std::size_t i = 0; i < all.size(); i += 77) {
    ASSERT_EQ(all.values[0][i], SampleRecording::left(i));
    ASSERT_NEAR(all.position[i], 102500 - 30 * static_cast<double>(i) / 25000, 1e-6);
    ASSERT_NEAR(all.speed[i], 30, 1e-6);
    ASSERT_NEAR(all.latitude[i], 46.9 + 0.001 * static_cast<double>(i) / SampleRecording::samples, 1e-9);
  }
}

TEST(RcmDxRecord, withoutPositionsTheSpeedIsAskedFor) {
  const TemporaryFile file("", ".rcmdx");
  SampleRecording sample;
  sample.withPositions = false;
  sample.write(file.path());
  EXPECT_THAT(complaintAbout(file.path()), HasSubstr("give the speed"));
  RecordOptions options;
  options.columns.speed = 30;
  options.columns.column = "all";
  options.columns.object = "DFZ01.ABA.FAST";
  EXPECT_EQ(readWhole(file.path(), options).layout.channels.size(), 2u);
}

TEST(RcmDxRecord, offsetsOnTracksStartAnewWithEachTrack) {
  const TemporaryFile file("", ".rcmdx");
  SampleRecording().write(file.path());
  RecordOptions options;
  options.columns.positionColumn = "track offset";
  const auto whole = readWhole(file.path(), options);
  EXPECT_EQ(whole.layout.rate, 25000);
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("goes back by 119.4 m"));
  options.columns.positionColumn = "mileage";
  EXPECT_THAT(complaintAbout(file.path(), options), HasSubstr("has no column 'mileage'"));
}

}  // namespace
}  // namespace squat::records
