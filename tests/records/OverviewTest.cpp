// The strip of a long record: extremes of every stretch, whatever the zoom and the direction of travel.
#include "records/Overview.h"

#include <gmock/gmock.h>

#include <cmath>

namespace squat::records {
namespace {

RecordLayout layout() {
  RecordLayout layout;
  layout.channels = {{"left", "m/s2"}, {"right", "m/s2"}};
  return layout;
}

// `count` samples, a centimetre apart from `start` on; one strike of 50 up and 30 down at sample `strike`.
RecordBlock block(double start, std::size_t count, std::size_t strike, double step = 0.01) {
  RecordBlock block;
  block.values.assign(2, std::vector<double>(count, 1.0));
  for (std::size_t i = 0; i < count; ++i) block.position.push_back(start + step * static_cast<double>(i));
  if (strike + 1 < count) block.values[1][strike] = 50, block.values[1][strike + 1] = -30;
  return block;
}

double highestOf(const Envelope& envelope) { return *std::max_element(envelope.high.begin(), envelope.high.end()); }
double lowestOf(const Envelope& envelope) { return *std::min_element(envelope.low.begin(), envelope.low.end()); }

TEST(Overview, KeepsEveryStrikeAtEveryZoom) {
  Overview overview;
  EXPECT_EQ(overview.extent().first, overview.extent().second);
  overview.add(layout(), block(1000, 5000, 10000));
  overview.add(layout(), block(1050, 5000, 2345));
  EXPECT_NEAR(overview.extent().first, 1000, Overview::stretch);
  EXPECT_NEAR(overview.extent().second, 1100, 2 * Overview::stretch);
  for (const std::size_t points : {3, 10, 100, 100000}) {
    const auto envelope = overview.envelope(1, 0, 5000, points);
    EXPECT_LE(envelope.position.size(), std::max<std::size_t>(2 * points, points + 2));
    EXPECT_EQ(highestOf(envelope), 50);
    EXPECT_EQ(lowestOf(envelope), -30);
    EXPECT_EQ(highestOf(overview.envelope(0, 0, 5000, points)), 1);
  }
  // The place of the strike, 1050 m and 23.45 m, to a stretch.
  const auto close = overview.envelope(1, 1073, 1074, 1000);
  EXPECT_GE(close.position.size(), 10U);
  EXPECT_EQ(highestOf(close), 50);
  for (std::size_t i = 0; i < close.position.size(); ++i)
    EXPECT_EQ(close.high[i] > 1, std::abs(close.position[i] - 1073.45) < 0.5 * Overview::stretch + 1e-9);
}

TEST(Overview, ChainageMayFall) {
  Overview overview;
  overview.add(layout(), block(500, 3000, 1000, -0.01));
  EXPECT_NEAR(overview.extent().first, 470, 2 * Overview::stretch);
  EXPECT_EQ(highestOf(overview.envelope(1, 489.5, 490.5, 100)), 50);
  EXPECT_EQ(highestOf(overview.envelope(1, 491, 500, 100)), 1);
  const auto all = overview.envelope(1, 0, 1000, 200);
  EXPECT_TRUE(std::is_sorted(all.position.begin(), all.position.end()));
}

TEST(Overview, WhatIsNoPlaceOrNoNumberIsLeftOut) {
  Overview overview;
  auto bad = block(0, 100, 200);
  bad.values[0][5] = NAN, bad.position[6] = NAN, bad.position[7] = 1e12;
  overview.add(layout(), bad);
  EXPECT_NEAR(overview.extent().second, 1, 2 * Overview::stretch);
  EXPECT_EQ(highestOf(overview.envelope(0, -10, 10, 1000)), 1);
  // A jump of a million kilometres costs its samples, not the memory.
  overview.add(layout(), block(9e8, 100, 50));
  EXPECT_NEAR(overview.extent().second, 1, 2 * Overview::stretch);
  EXPECT_TRUE(overview.envelope(5, 0, 1, 10).position.empty());
}

}  // namespace
}  // namespace squat::records
