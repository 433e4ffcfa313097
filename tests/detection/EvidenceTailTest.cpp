// What the background makes by itself, from the record alone.
#include "detection/EvidenceTail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/Monitor.h"
#include "detection/Detect.h"
#include "detection/RecordMaker.h"

namespace squat::detection {
namespace {

// Largest evidences in a metre of white noise at 5 kHz and 30 m/s, 40 000 of them, by the share that stays below
// (frozen); between them straight lines over -ln(-ln share).
double whiteQuantile(double share) {
  constexpr double shares[] = {0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999, 0.9999};
  constexpr double values[] = {0.62, 1.08, 1.50, 2.02, 3.02, 4.99, 6.98, 9.52};
  const auto ordinate = [](double p) { return -std::log(-std::log(p)); };
  std::size_t i = 1;
  while (i + 1 < std::size(shares) && shares[i] < share) ++i;
  const double t = (ordinate(share) - ordinate(shares[i - 1])) / (ordinate(shares[i]) - ordinate(shares[i - 1]));
  return values[i - 1] + t * (values[i] - values[i - 1]);
}

std::vector<double> maxima(double factor, double exponent, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(factor * std::pow(whiteQuantile((i + 0.5) / count), exponent));
  return values;
}

// One metre in 10 000 is 0.1 in a kilometre. 15 %: the parabola for the frozen values, taken to the power.
TEST(EvidenceTail, IsThatOfTheRecord) {
  for (const double exponent : {1.0, 1.5, 2.0}) {
    const EvidenceTail tail(maxima(1.7, exponent, 10'000));
    const double expected = 1.7 * std::pow(9.52, exponent);
    EXPECT_NEAR(tail.evidenceOf(0.1), expected, 0.15 * expected) << exponent;
    EXPECT_NEAR(std::log(tail.alarmsPerKilometre(tail.evidenceOf(0.1))), std::log(0.1), 1e-6);
  }
}

// Events in a fifth of the metres: 60 % of all are then 75 % of the background (2.2 in place of 1.74), and 30 %
// are 37.5 % (1.24 in place of 1.08). The power is ln(2.2 / 1.24) / ln(1.74 / 1.08) = 1.2, so 9.52 becomes some 16.
TEST(EvidenceTail, EventsMoveItByLessThanTheyAreLoud) {
  auto values = maxima(1, 1, 800);
  values.resize(1000, 20'000);
  const double seen = EvidenceTail(values).evidenceOf(0.1);
  EXPECT_GT(seen, 9);
  EXPECT_LT(seen, 22);
}

TEST(EvidenceTail, OfARecordOfFewMetresIsThatOfWhiteNoise) {
  EXPECT_NEAR(EvidenceTail({}).evidenceOf(0.1), 9.52, 0.5);
  EXPECT_NEAR(EvidenceTail({2, 3}).evidenceOf(0.1), 9.52, 2.5);
}

// 20 km of noise whose level swells and fades over some metres by a factor of two: what is chosen is what is counted.
// Ten alarms are expected; 1 to 25 are within three deviations of a count and a factor of one and a half for the tail.
TEST(EvidenceTail, CountsAsManyAlarmsAsWereChosen) {
  constexpr double sampling = 5000, speed = 40;
  auto values = normalNoise(static_cast<std::size_t>(20'000 / speed * sampling), 3, 11);
  const auto slow = normalNoise(values.size() / 1000 + 2, 0.25, 12);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t k = i / 1000;
    values[i] *= std::exp(std::lerp(slow[k], slow[k + 1], static_cast<double>(i % 1000) / 1000));
  }
  MemoryStream stream(std::move(values), sampling, speed, 1 << 18);
  Monitor monitor;
  DetectOptions options;
  options.threshold = 5;
  auto found = findCandidates(stream, options, monitor);
  auto& channel = found.channels[0];
  std::vector<double> all;
  for (const auto& piece : channel.pieces) all.push_back(piece.evidence);
  const EvidenceTail tail(all);
  const auto alarms = std::count_if(channel.events.begin(), channel.events.end(),
                                    [&](const Event& event) { return tail.alarmsPerKilometre(event.score) < 0.5; });
  EXPECT_GE(alarms, 1);
  EXPECT_LE(alarms, 25);
}

}  // namespace
}  // namespace squat::detection
