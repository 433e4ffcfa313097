// Passes whose counters differ by metres are one list.
#include "detection/Passes.h"

#include <gmock/gmock.h>

#include "detection/RecordMaker.h"
#include "detection/Stretches.h"

namespace squat::detection {
namespace {

RecordDetection passWith(const std::vector<double>& places, double shift, double speed) {
  RecordDetection detection;
  detection.layout.path = "pass";
  detection.channels.push_back({"left", {}, {}, 0});
  for (int metre = 0; metre < 100; ++metre) detection.channels[0].pieces.push_back({metre + shift, 1, 1});
  constexpr double rate = 5000;
  for (const double place : places) {
    Event event;
    event.channel = "left", event.unit = "m/s2";
    event.kind = Kind::squat, event.sureness = 0.9, event.score = 100;
    event.position = place + shift, event.time = place / speed;
    event.features.speed = speed;
    event.judgement.severitySureness = 0.8;
    event.passage = {event.time - 0.5 / speed, 1 / rate,
                     normalNoise(static_cast<std::size_t>(1.5 / speed * rate), 0.01, 1), "left", "m/s2"};
    addImpact(event.passage.values, rate, 0.5 / speed, 50);
    detection.channels[0].events.push_back(event);
  }
  return detection;
}

TEST(Passes, AreMovedOntoTheFirst) {
  const auto events = combine({passWith({10, 33.3, 61, 80}, 0, 30), passWith({10.02, 33.28, 61.01, 80}, 3.7, 30)});
  ASSERT_EQ(events.size(), 4U);
  for (const auto& event : events) {
    EXPECT_EQ(event.event.passes, 2U);
    EXPECT_EQ(event.event.passesThere, 2U);
  }
  EXPECT_NEAR(events[1].event.position, 33.3, 0.05);
}

TEST(Passes, AnEventThatOneDoesNotHaveIsMarked) {
  const auto events = combine({passWith({10, 33.3, 61}, 0, 30), passWith({10, 61}, 0, 30)});
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].event.passes, 1U);
  EXPECT_EQ(events[1].event.passesThere, 2U);
}

// 12 mm of scatter in the places found, none in the signals: what is left is a sample of 6 mm and the interpolation.
TEST(Passes, EventsAreMovedToWhereTheirSignalsMatch) {
  auto one = passWith({10, 33.3, 61}, 0, 30), other = passWith({10, 33.3, 61}, 0, 30);
  for (std::size_t i = 0; i < 3; ++i) {
    auto& event = other.channels[0].events[i];
    const double moved = i == 1 ? 0.06 : -0.06;  // found later or earlier than it is
    event.position += moved, event.time += moved / 30;
  }
  for (const auto& event : combine({one, other})) EXPECT_LT(event.scatter, 0.02) << event.event.position;
}

// Two of three passes say moderate, the loudest says severe: length and depth are those of a moderate one.
TEST(Passes, SizesAgreeWithTheSeverityThatMostHave) {
  std::vector<RecordDetection> passes(3, passWith({10, 33.3, 61}, 0, 30));
  for (auto& pass : passes)
    for (auto& event : pass.channels[0].events)
      event.judgement.severity = Severity::moderate, event.judgement.length = 0.05, event.judgement.depth = 0.2e-3;
  auto& loudest = passes[1].channels[0].events[1];
  loudest.score = 200;
  loudest.judgement.severity = Severity::severe, loudest.judgement.length = 0.08, loudest.judgement.depth = 0.3e-3;
  const auto events = combine(passes);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].event.judgement.severity, Severity::moderate);
  EXPECT_EQ(events[1].event.judgement.length, 0.05);
  EXPECT_EQ(events[1].event.judgement.depth, 0.2e-3);
}

// What was seen on site is not outvoted.
TEST(Passes, ALabelDecides) {
  std::vector<RecordDetection> passes(3, passWith({10, 33.3, 61}, 0, 30));
  auto& seen = passes[2].channels[0].events[1];
  seen.label.emplace();
  seen.label->kind = seen.kind = Kind::weld, seen.sureness = 1, seen.score = 50, seen.reason = "as labelled";
  const auto events = combine(passes);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].event.kind, Kind::weld);
  EXPECT_EQ(events[1].event.reason, "as labelled");
  EXPECT_EQ(events[0].event.kind, Kind::squat);
}

TEST(Passes, RecordsOfOtherPlacesAreListedOneBehindTheOther) {
  const auto events = combine({passWith({10, 33.3}, 0, 30), passWith({10, 33.3}, 5000, 30)});
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[0].event.passesThere, 1U);
}

RecordDetection withWaves(double from, double to, double wavelength, double speed) {
  auto detection = passWith({}, 0, speed);
  detection.channels[0].waves = {{1, from, to, wavelength, wavelength, wavelength, 0.6, speed, speed}};
  return detection;
}

// Two passes see one stretch; at speeds that differ by a fifth its waves are none of a resonance. Other waves, and
// those somewhere else, are another stretch.
TEST(Stretches, OfSeveralPassesAreOne) {
  const std::vector<RecordDetection> steady{withWaves(10, 50, 0.05, 20), withWaves(18, 62, 0.052, 21)};
  auto stretches = combinedStretches(steady, {0, 0});
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR(stretches[0].event.position, 10, 1e-9);
  EXPECT_NEAR(stretches[0].event.extent, 52, 1e-9);
  EXPECT_EQ(stretches[0].event.passes, 2U);
  EXPECT_EQ(stretches[0].event.passesThere, 2U);
  const std::vector<RecordDetection> varied{withWaves(10, 50, 0.05, 20), withWaves(18, 62, 0.052, 28)};
  EXPECT_GT(combinedStretches(varied, {0, 0})[0].event.sureness, stretches[0].event.sureness);
  EXPECT_EQ(combinedStretches({withWaves(10, 50, 0.05, 20), withWaves(18, 62, 0.06, 21)}, {0, 0}).size(), 2U);
  EXPECT_EQ(combinedStretches({withWaves(10, 50, 0.05, 20), withWaves(45, 80, 0.05, 21)}, {0, 0}).size(), 2U);
  EXPECT_EQ(combinedStretches(steady, {0, 40}).size(), 2U) << "another chainage";
}

}  // namespace
}  // namespace squat::detection
