// What stands out of noise, and where.
#include "detection/Candidates.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "core/Monitor.h"
#include "detection/Detect.h"
#include "detection/RecordMaker.h"
#include "readers/TemporaryFile.h"
#include "records/RecordStream.h"

namespace squat::detection {
namespace {

constexpr double rate = 25'000, trainSpeed = 30;

RecordDetection candidatesOf(std::vector<double> values, std::size_t block = 1 << 18) {
  MemoryStream stream(std::move(values), rate, trainSpeed, block);
  Monitor monitor;
  return findCandidates(stream, {}, monitor);
}

// 60 s of noise are some 7,500 looks of 8 ms; evidence of 14 and more has a probability of e^-14 in each, were the
// looks one variable: below one in a hundred in all. Two are allowed: the level itself is estimated.
TEST(Candidates, NoiseAloneHasNone) {
  EXPECT_LE(candidatesOf(normalNoise(60 * 25'000, 4, 1)).channels[0].events.size(), 2U);
}

// Impacts of three times the noise's root mean square below 2 kHz, which is 0.4 of that of all (2 of 12.5 kHz).
// Squats ring up to some 900 Hz at least (paper, section 4: 1060-1130 Hz): below 2000 Hz of sampling nothing can be
// said.
TEST(Candidates, ARecordThatIsSampledTooSlowlyIsRefused) {
  Monitor monitor;
  MemoryStream slow(normalNoise(20'000, 1, 3), 1000, 30, 4096);
  try {
    findCandidates(slow, {}, monitor);
    FAIL() << "taken";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("is sampled at 1000 Hz"));
  }
  MemoryStream cut(normalNoise(40'000, 1, 3), 2000, 30, 4096);
  EXPECT_THAT(findCandidates(cut, {}, monitor).layout.notes,
              ::testing::Contains(::testing::HasSubstr("does not show")));
}

// Of 20,000 rows, 5,000 have no number: three quarters were read.
TEST(Candidates, ARecordThatIsMostlyUnreadIsRefusedUnlessAllowed) {
  std::string text = "time [s],aba [m/s2]\n";
  const auto values = normalNoise(20'000, 1, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    text +=
        std::to_string(static_cast<double>(i) / 10'000) + "," + (i < 5'000 ? "-" : std::to_string(values[i])) + "\n";
  const tests::TemporaryFile file(text);
  records::RecordOptions read;
  read.columns.speed = 30;
  Monitor monitor;
  try {
    findCandidates(*records::openRecord(file.path(), read), {}, monitor);
    FAIL() << "taken";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::AllOf(::testing::HasSubstr("75 % of its 20000 samples"),
                                               ::testing::HasSubstr("--least-share")));
  }
  DetectOptions options;
  options.leastShare = 0.5;
  EXPECT_NO_THROW(findCandidates(*records::openRecord(file.path(), read), options, monitor));
}

TEST(Candidates, ImpactsOfThreeTimesTheNoiseAreFoundWhereTheyAre) {
  const double sigma = 4;
  auto values = normalNoise(40 * 25'000, sigma, 2);
  std::vector<double> times;
  for (double time = 2; time < 39; time += 1.7) times.push_back(time);
  for (const double time : times) addImpact(values, rate, time, 3 * 0.4 * sigma);
  const auto events = candidatesOf(values).channels[0].events;
  std::size_t found = 0;
  for (const double time : times)
    for (const auto& event : events)
      if (std::abs(event.time - time) < 0.1 / trainSpeed) {  // 0.1 m, what a list of squats must hold
        ++found;
        break;
      }
  EXPECT_GE(found, times.size() * 9 / 10) << times.size() << " impacts, " << events.size() << " candidates";
}

// Segments of 21 s that overlap give the same list as one that holds all; block sizes do not matter.
TEST(Candidates, DoNotDependOnBlocksAndSegments) {
  auto values = normalNoise(90 * 25'000, 1, 3);
  for (double time = 5; time < 88; time += 4.3) addImpact(values, rate, time, 30);
  const auto whole = candidatesOf(values).channels[0].events;
  const auto pieces = candidatesOf(values, 1000).channels[0].events;
  ASSERT_EQ(whole.size(), 20U);
  ASSERT_EQ(pieces.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i].time, pieces[i].time);
    EXPECT_EQ(whole[i].features.energy, pieces[i].features.energy);
  }
}

TEST(Candidates, TheOverviewHoldsEveryMetreOnce) {
  auto values = normalNoise(30 * 25'000, 2, 4);
  addImpact(values, rate, 10.01, 50);
  const auto pieces = candidatesOf(values).channels[0].pieces;
  EXPECT_NEAR(static_cast<double>(pieces.size()), 30 * trainSpeed, 2);
  EXPECT_NEAR(pieces[100].rms, 2 * 0.4, 0.15) << "the share of noise below 2 kHz";
  EXPECT_GT(pieces[300].peak, 25) << "the metre of the impact, at 300.3 m";
}

TEST(Candidates, AWheelThatStandsStillHasNone) {
  auto values = normalNoise(10 * 25'000, 1, 6);
  addImpact(values, rate, 5, 100);
  MemoryStream stream(values, rate, 1.0, 1 << 18);  // [m/s], below the slowest that is looked at
  Monitor monitor;
  EXPECT_TRUE(findCandidates(stream, {}, monitor).channels[0].events.empty());
}

// A channel that falls to zero from an offset of 10 m/s2 for 6 s, which is more than the window of the local level (30
// m): neither its ends nor its silence make events, and an impact half a second behind it is found where it is.
TEST(Candidates, ADeadChannelMakesNoEventsAndHidesNone) {
  auto values = normalNoise(30 * 25'000, 2, 8);
  for (auto& value : values) value += 10;
  for (const double time : {5.0, 18.5}) addImpact(values, rate, time, 60);
  std::fill(values.begin() + 12 * 25'000, values.begin() + 18 * 25'000, 0.0);
  const auto events = candidatesOf(values).channels[0].events;
  ASSERT_EQ(events.size(), 2U);
  EXPECT_NEAR(events[0].time, 5, 0.1 / trainSpeed);
  EXPECT_NEAR(events[1].time, 18.5, 0.1 / trainSpeed);
}

// Corrugation is what is loud for two metres and more (Surroundings.h). A ringing of 16 ms has decayed to a tenth of
// its power after 18 ms, 0.55 m; wavelets and the pieces of 0.25 m add as much again at most.
TEST(Candidates, SquatsInARowAreNotOneLongStretch) {
  constexpr double apart = 2.5, decay = 16e-3;
  auto values = normalNoise(20 * 25'000, 1, 9);
  for (std::size_t i = 10 * 25'000; i < values.size(); ++i) {
    const double since = std::fmod(static_cast<double>(i) / rate - 10, apart / trainSpeed);
    if (static_cast<double>(i) / rate < 10 + 5 * apart / trainSpeed)
      values[i] += 20 * std::exp(-since / decay) * std::sin(2 * std::numbers::pi * 600 * since);
  }
  const auto events = candidatesOf(values).channels[0].events;
  ASSERT_EQ(events.size(), 5U);
  for (const auto& event : events) EXPECT_LE(event.features.reach, 1.0) << event.position;
}

// Waves of 47 and 54 mm, which beat every 0.4 m, on 6 m of track.
TEST(Candidates, CorrugationIsOneLongStretch) {
  auto values = normalNoise(20 * 25'000, 1, 10);
  const auto first = static_cast<std::size_t>(10 * rate), length = static_cast<std::size_t>(6 / trainSpeed * rate);
  for (std::size_t i = 0; i < length; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / rate;
    values[first + i] += 20 * (std::sin(640 * angle) + 0.6 * std::sin(560 * angle));
  }
  const auto events = candidatesOf(values).channels[0].events;
  ASSERT_FALSE(events.empty());
  for (const auto& event : events) EXPECT_GE(event.features.reach, 2) << event.position;
}

}  // namespace
}  // namespace squat::detection
