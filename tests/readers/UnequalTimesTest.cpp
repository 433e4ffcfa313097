// A sine of 300 Hz sampled at unequal times: put on equal steps it is that sine again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "readers/SignalFile.h"
#include "readers/TemporaryFile.h"

namespace squat::readers {
namespace {

using testing::Contains;
using testing::HasSubstr;

double sineAt(double time) { return 50 * std::sin(2 * M_PI * 300 * time); }

std::string tableOf(const std::vector<double>& times) {
  std::string text = "time [s],aba [m/s2]\n";
  char row[80];
  for (const double time : times) {
    std::snprintf(row, sizeof row, "%.9f,%.9f\n", time, sineAt(time));
    text += row;
  }
  return text;
}

// Of a polynomial through eight samples at steps h, the error of a sine is below (w h)^8 (3.5 2.5 1.5 0.5)^2 / 8! of
// its size: 2.2e-5 m/s2 at 0.2 ms, 3.2e-4 at 0.28 ms, some times that where steps are mixed. The ends, where all
// samples are on one side, are left out.
void expectSine(const signals::Record& record, double tolerance, double from, double to) {
  for (std::size_t i = 0; i < record.time.size(); ++i)
    if (record.time[i] > from && record.time[i] < to) {
      ASSERT_NEAR(record.signals[0].values[i], sineAt(record.time[i]), tolerance) << record.time[i];
    }
}

TEST(UnequalTimes, OfARateThatChangesAreResampled) {
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) times.push_back(i * 0.0002);
  for (int i = 0; i < 1000; ++i) times.push_back(0.4 + i * 0.00028);
  const tests::TemporaryFile file(tableOf(times));
  const auto record = readSignals(file.path()).at(0);
  EXPECT_THAT(record.notes, Contains(HasSubstr("not equally spaced")));
  EXPECT_NEAR(record.time[1] - record.time[0], 0.0002, 1e-9);
  expectSine(record, 1.5e-3, 0.002, 0.677);
}

TEST(UnequalTimes, OfAJitteringClockAreResampled) {
  std::mt19937 random(1);
  std::vector<double> times;
  for (int i = 0; i < 3000; ++i)
    times.push_back((i + 0.2 * (static_cast<double>(random()) / 4294967296.0 - 0.5)) * 0.0002);
  const tests::TemporaryFile file(tableOf(times));
  const auto record = readSignals(file.path()).at(0);
  EXPECT_THAT(record.notes, Contains(HasSubstr("not equally spaced")));
  // Taken as equally spaced, samples would be off by up to 50 m/s2 times 2 pi 300 Hz times 20 us, 1.9 m/s2.
  expectSine(record, 1e-3, 0.002, 0.597);
}

TEST(UnequalTimes, OfFewDigitsAreEqual) {
  std::string text = "time [s],aba [m/s2]\n";
  char row[80];
  for (int i = 0; i < 3000; ++i) {
    std::snprintf(row, sizeof row, "%.5f,%.9f\n", i / 25600.0, sineAt(i / 25600.0));
    text += row;
  }
  const tests::TemporaryFile file(text);
  const auto record = readSignals(file.path()).at(0);
  EXPECT_TRUE(record.notes.empty()) << record.notes.front();
  EXPECT_NEAR(record.time[1] - record.time[0], 1 / 25600.0, 1e-8);
  EXPECT_DOUBLE_EQ(record.signals[0].values[100], std::stod(text.substr(text.find(',', text.find("0.00391")) + 1)));
}

}  // namespace
}  // namespace squat::readers
