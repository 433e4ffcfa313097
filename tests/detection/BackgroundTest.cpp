// What is background, what is none, and what is said of it.
#include <gmock/gmock.h>

#include "case/ShippedCases.h"
#include "detection/BackgroundSections.h"
#include "detection/ChannelNotes.h"
#include "detection/ExampleSource.h"
#include "detection/RecordMaker.h"
#include "detection/Stretches.h"

namespace squat::detection {
namespace {

constexpr double hertz = 5000, metresPerSecond = 30;

DetectionReport reportOf(std::vector<double> values, const DetectOptions& options = {}) {
  MemoryStream stream(std::move(values), hertz, metresPerSecond, 1 << 16);
  Monitor unwatched;
  std::vector<RecordDetection> records;
  records.push_back(findCandidates(stream, options, unwatched));
  ExampleSource source;
  source.examples = readExamples((cases::resourcesFolder() / "detection/examples.csv").string());
  source.sizes = SizeModel(source.examples);
  return *judged(std::move(records), source, options, unwatched);
}

long countOf(const DetectionReport& report, Kind kind) {
  return std::count_if(report.events.begin(), report.events.end(),
                       [kind](const CombinedEvent& each) { return each.event.kind == kind; });
}

// A kilometre in which a flat strikes in every turn, 346 times: it rings in more than half of all metres, and is still
// no background. Nor does it hide an impact of six times its strength half-way between two strikes.
TEST(Background, AFlatInEveryTurnIsNone) {
  auto values = normalNoise(static_cast<std::size_t>(1000 / metresPerSecond * hertz), 1, 8);
  for (double x = 2; x < 998; x += 2.89) addImpact(values, hertz, x / metresPerSecond, 40);
  addImpact(values, hertz, (2 + 100.5 * 2.89) / metresPerSecond, 240);
  const auto report = reportOf(std::move(values));
  EXPECT_GE(countOf(report, Kind::flat), 330);
  EXPECT_NEAR(report.records[0].channels[0].circumference, 2.89, 0.01);
  EXPECT_THAT(report.records[0].notes, ::testing::Not(::testing::Contains(::testing::HasSubstr("swells"))));
  const auto isThere = [](const CombinedEvent& each) {
    return std::abs(each.event.position - (2 + 100.5 * 2.89)) < 0.3 && each.event.kind != Kind::flat;
  };
  EXPECT_TRUE(std::any_of(report.events.begin(), report.events.end(), isThere));
}

// Pieces in which a channel is dead have an evidence of zero. Left out, the rest is as before.
TEST(Background, SilentMetresAreNone) {
  std::vector<Piece> pieces;
  for (int i = 0; i < 600; ++i) pieces.push_back({1.0 * i, 1, 1, 1 + 0.004 * i});
  const double awake = backgroundSections(pieces).front().tail.evidenceOf(0.1);
  for (int i = 600; i < 1000; ++i) pieces.push_back({1.0 * i, 0, 0, 0});
  EXPECT_DOUBLE_EQ(backgroundSections(pieces).front().tail.evidenceOf(0.1), awake);
}

// What the user accepts decides what is listed: of impacts that stand out by little, fewer alarms list fewer.
TEST(Background, FewerFalseAlarmsListLess) {
  auto values = normalNoise(static_cast<std::size_t>(600 / metresPerSecond * hertz), 1, 9);
  const auto swell = normalNoise(values.size() / 500 + 2, 0.5, 10);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= std::exp(swell[i / 500]);
  for (double x = 20; x < 580; x += 20) addImpact(values, hertz, x / metresPerSecond, 6 + 0.02 * x);
  DetectOptions many, few;
  many.falseAlarms = 50, few.falseAlarms = 1e-6;
  const auto listed = reportOf(values, many).events.size(), left = reportOf(values, few).events.size();
  EXPECT_GT(listed, left);
}

TEST(ChannelNotes, SayWhereTheBackgroundIsRestless) {
  ChannelDetection channel{"left", {}, {}, 0};
  for (int i = 0; i < 1000; ++i) channel.pieces.push_back({1.0 * i, 1, 1, std::exp(0.006 * i)});
  channel.background = backgroundSections(channel.pieces);
  EXPECT_THAT(channelNotes(channel, {}),
              ::testing::ElementsAre(::testing::HasSubstr("swells and fades; from 0 to 1000 m")));
  for (auto& piece : channel.pieces) piece.evidence = 1 + 0.001 * piece.position;
  channel.background = backgroundSections(channel.pieces);
  EXPECT_THAT(channelNotes(channel, {}), ::testing::IsEmpty());
}

TEST(ChannelNotes, SayWhatAResonanceWouldLookLike) {
  ChannelDetection channel{"left", {}, {}, 0};
  channel.waves = {{1, 20, 84, 0.05, 0.05, 0.05, 0.6, 20, 20}, {9, 200, 300, 0.05, 0.05, 0.05, 0.6, 15, 25}};
  EXPECT_THAT(channelNotes(channel, {}), ::testing::ElementsAre(::testing::HasSubstr("a resonance at 400 Hz")));
  const auto events = stretchEvents(channel, "m/s2");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].extent, 64);
  EXPECT_LT(events[0].sureness, events[1].sureness) << "only the second was passed at speeds that vary";
}

}  // namespace
}  // namespace squat::detection
