// A record cut into overlapping segments: nothing lost, nothing twice.
#include "detection/Segments.h"

#include <gmock/gmock.h>

#include "detection/RecordMaker.h"

namespace squat::detection {
namespace {

std::vector<Segment> segmentsOf(double seconds, std::size_t block) {
  MemoryStream stream(normalNoise(static_cast<std::size_t>(seconds * 25'000), 1, 7), 25'000, 30, block);
  SegmentCutter cutter(stream.layout(), std::size_t{1} << 17, 60);
  std::vector<Segment> all;
  records::RecordBlock part;
  while (stream.next(part))
    for (auto& segment : cutter.push(part)) all.push_back(std::move(segment));
  for (auto& segment : cutter.finish()) all.push_back(std::move(segment));
  return all;
}

TEST(Segments, CoresFollowOnEachOtherWithMarginsAround) {
  const auto segments = segmentsOf(30, 10'000);
  ASSERT_GT(segments.size(), 4U);
  EXPECT_DOUBLE_EQ(segments.front().coreStart, 0);
  EXPECT_NEAR(segments.back().coreEnd, 30, 1e-3);
  for (std::size_t i = 1; i < segments.size(); ++i) {
    EXPECT_NEAR(segments[i].coreStart, segments[i - 1].coreEnd, 1e-9);
    const auto& series = segments[i].channels.front();
    EXPECT_LE(series.start, segments[i].coreStart - 1.9) << "60 m at 30 m/s are 2 s";
  }
}

TEST(Segments, AreDecimatedToTheRateThatShowsTwoKilohertz) {
  const auto segment = segmentsOf(10, 250'000).front();
  EXPECT_DOUBLE_EQ(segment.channels.front().rate(), 5000);
  EXPECT_EQ(segment.position.size(), segment.channels.front().values.size());
  EXPECT_NEAR(segment.position[100], 30 * 100 / 5000.0, 1e-9);
}

}  // namespace
}  // namespace squat::detection
