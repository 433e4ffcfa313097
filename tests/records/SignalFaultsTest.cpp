// Faults of the signal itself: what is found, what is mended, and that a rough but honest signal has none.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>

#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::TemporaryFile;

constexpr std::size_t samples = 50000;
constexpr double rate = 25000, speed = 30;

// Noise of 3 m/s2 on an offset of 9.81, at 30 m/s from km 2 on; in blocks of 7000 samples.
WholeRecord read(const std::function<void(std::vector<double>&)>& change) {
  std::mt19937 engine(7);
  std::normal_distribution<double> noise(9.81, 3);
  std::vector<double> values(samples);
  for (auto& value : values) value = noise(engine);
  change(values);
  std::string text = "time [s],aba [m/s2]\n";
  for (std::size_t i = 0; i < samples; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "%.5f,%.6g\n", static_cast<double>(i) / rate, values[i]);
    text += line;
  }
  const TemporaryFile file(text);
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = speed;
  options.chainage = 2000;
  options.blockLength = 7000;
  return readWhole(file.path(), options);
}

// What a wheel does over a severe squat: 600 m/s2, a rise within a tenth of a millisecond, ringing at 1000 Hz.
void strike(std::vector<double>& values, std::size_t at, double size = 600) {
  for (std::size_t i = 0; i < 250; ++i) {
    const double t = static_cast<double>(i) / rate;
    values[at + i] += size * std::exp(-t / 2e-3) * std::sin(2 * std::numbers::pi * 1000 * t);
  }
}

TEST(SignalFaults, impactsAreNone) {
  const auto whole = read([](std::vector<double>& values) {
    for (std::size_t at = 3000; at + 300 < samples; at += 3998) strike(values, at);  // some across ends of blocks
  });
  EXPECT_THAT(whole.faults, IsEmpty());
}

TEST(SignalFaults, aSpikeIsReportedAndReplaced) {
  const auto whole = read([](std::vector<double>& values) {
    values[20000] = 4000;
    values[30000] = values[30001] = -3000;
    values[7000] = 5000;   // first of a block
    values[13999] = 5000;  // last of a block
    strike(values, 40000);
  });
  const auto spikes = whole.faultsOf(FaultKind::spike);
  ASSERT_EQ(whole.faults.size(), 4u);
  ASSERT_EQ(spikes.size(), 4u);
  EXPECT_EQ(spikes[2].first, 20000u);
  EXPECT_NEAR(spikes[2].time, 0.8, 1e-9);
  EXPECT_NEAR(spikes[2].position, 2024, 1e-6);
  EXPECT_THAT(spikes[2].text, HasSubstr("in one sample"));
  EXPECT_EQ(spikes[3].end, 30002u);
  const auto& values = whole.stretches[0].values[0];
  // A straight line between two samples of the noise: five of its deviations at most (1e-6 of all noise is beyond).
  for (const std::size_t i : {20000u, 30000u, 30001u, 7000u, 13999u}) EXPECT_NEAR(values[i], 9.81, 15) << i;
}

// The line that replaces a spike meets both neighbours, also where the next one is in another block.
TEST(SignalFaults, theLineMeetsTheNextBlock) {
  const auto whole = read([](std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 10 * std::sin(static_cast<double>(i) / 100);
    values[13999] = 5000;
  });
  ASSERT_EQ(whole.faults.size(), 1u);
  // A line misses the sine by its curvature, 10 (1/100)^2 / 2 = 5e-4.
  EXPECT_NEAR(whole.stretches[0].values[0][13999], 10 * std::sin(139.99), 1e-3);
}

TEST(SignalFaults, aSignalCutOffAtTheLimitOfItsRange) {
  const auto whole = read([](std::vector<double>& values) {
    strike(values, 10000, 2000);
    strike(values, 35000, 2000);
    for (auto& value : values) value = std::min(value, 490.0);
  });
  const auto cut = whole.faultsOf(FaultKind::saturation);
  ASSERT_EQ(whole.faults.size(), 2u);
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_THAT(cut[0].text, HasSubstr("cut off at 490"));
  // The sine of 2000 passes 480 after 0.24 rad of 2 pi 1000 Hz: a sample and a quarter behind the strike.
  EXPECT_NEAR(static_cast<double>(cut[0].first), 10001, 1);
  EXPECT_NEAR(static_cast<double>(cut[1].first), 35001, 1);
  EXPECT_EQ(whole.stretches.size(), 1u);
}

TEST(SignalFaults, aCoarseConverterAtRestIsNoLimit) {
  const auto whole = read([](std::vector<double>& values) {
    for (auto& value : values) value = std::round(value / 5) * 5;  // three or four steps carry all of the noise
  });
  EXPECT_THAT(whole.faults, IsEmpty());
}

TEST(SignalFaults, aChannelThatDies) {
  const auto whole =
      read([](std::vector<double>& values) { std::fill(values.begin() + 12000, values.begin() + 30000, 0.0); });
  ASSERT_EQ(whole.faults.size(), 1u);
  EXPECT_EQ(whole.faults[0].kind, FaultKind::deadChannel);
  EXPECT_EQ(whole.faults[0].channel, 0);
  EXPECT_EQ(whole.faults[0].first, 12000u);
  EXPECT_EQ(whole.faults[0].end, 30000u);
  EXPECT_NEAR(whole.faults[0].time, 0.48, 1e-9);
  EXPECT_NEAR(whole.faults[0].position, 2014.4, 1e-6);
  EXPECT_THAT(whole.faults[0].text, HasSubstr("stays at 0"));
}

TEST(SignalFaults, halfASecondOfSilenceIsTheLeast) {
  const auto whole = read([](std::vector<double>& values) {
    std::fill(values.begin() + 12000, values.begin() + 24000, 0.0);  // 0.48 s
  });
  EXPECT_THAT(whole.faultsOf(FaultKind::deadChannel), IsEmpty());
}

}  // namespace
}  // namespace squat::records
