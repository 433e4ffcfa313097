// Roughness back from records that formulas make: a mass m on a contact spring k with a damper c over a rigid track,
//   m u'' = -k (u - r) - c (u' - r'),   H = -w^2 (k + i w c) / (k + i w c - m w^2),
// rolls over a sum of harmonics, each of which answers by itself.
#include "roughness/RoughnessGauge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "roughness/RecordRoughness.h"
#include "scenario/Irregularity.h"
#include "signals/FourierTransform.h"

namespace squat::roughness {
namespace {

constexpr double oscillatorMass = 900, oscillatorSpring = 9e8, damper = 2e5;  // resonance at 159 Hz, damping ratio 0.11

std::complex<double> responseAt(double frequency) {
  const double omega = 2 * M_PI * frequency;
  const std::complex<double> contact(oscillatorSpring, omega * damper);
  return -omega * omega * contact / (contact - oscillatorMass * omega * omega);
}

TransferFunction transferOfMass() {
  TransferFunction transfer;
  for (double f = 10; f <= 2500; f += 2) {
    transfer.frequency.push_back(f);
    transfer.response.push_back(responseAt(f));
    transfer.power.push_back(std::norm(transfer.response.back()));
  }
  transfer.overSleeper = {"over a sleeper", transfer.power};
  transfer.midspan = {"midspan", transfer.power};
  for (double& power : transfer.midspan.power) power *= std::pow(10.0, -0.2);  // 2 dB
  transfer.halfPatch = 0.006;
  transfer.complete = true;
  return transfer;
}

scenario::IrregularSurface surface() {
  scenario::Irregularity options;
  options.seed = 3, options.shortest = 0.01, options.longest = 1.0;
  return scenario::IrregularSurface::ofSpectrum({{0.01, -8}, {0.04, -3.2}, {0.4, 17.1}, {1.0, 20}}, options, 0);
}

struct MadeRecord {
  std::vector<double> acceleration, position, height;
};

// What each harmonic of the surface is felt as at this speed; patches pass on what `filter` says.
MadeRecord made(double speed, double rate, double length, ContactFilter filter) {
  MadeRecord record;
  const auto rail = surface();
  struct Felt {
    double wavenumber, amplitude, phase, height, heightPhase;
  };
  std::vector<Felt> felt;
  for (const auto& h : rail.harmonics()) {
    const auto response =
        responseAt(h.wavenumber * speed / (2 * M_PI)) * contactFilter(filter, 2 * M_PI / h.wavenumber, 0.006);
    felt.push_back(
        {h.wavenumber, h.amplitude * std::abs(response), h.phase + std::arg(response), h.amplitude, h.phase});
  }
  const auto count = static_cast<long>(length / speed * rate);
  for (long i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) * speed / rate;
    double acceleration = 0, height = 0;
    for (const auto& each : felt) {
      acceleration += each.amplitude * std::cos(each.wavenumber * x + each.phase);
      height += each.height * std::cos(each.wavenumber * x + each.heightPhase);
    }
    record.acceleration.push_back(acceleration), record.position.push_back(x), record.height.push_back(height);
  }
  return record;
}

RecordRoughness measured(const MadeRecord& record, double rate, const TransferFunction& transfer,
                         const GaugeOptions& options) {
  return roughnessOf({{0, 1 / rate, record.acceleration, "aba", "m/s2"}, record.position}, transfer, options);
}

// 60 m at 20 m/s: 10 mm are 2000 Hz, 0.4 m 50 Hz. Heights and record go through the same windows, so that levels differ
// by the change of |H|^2 within a line alone. A line of Hann's window is 1/sqrt(3) of a bin wide (root mean
// square), 3.5 Hz for stretches of 0.165 s. Above 0.15 m |H|^2 goes with f^4: 28 % to either side of 50 Hz, which is
// 0.13 dB too much (6 x 3.5^2 / 50^2) and what the few harmonics of a band leave when they lie on one side. Below, the
// steepest place is the flank of the resonance, 3.5 Hz of the half-width of 17 Hz among six and more lines to a band.
TEST(RoughnessGauge, GivesTheHeightsBack) {
  constexpr double rate = 8192;
  const auto transfer = transferOfMass();
  const auto record = made(20, rate, 60, ContactFilter::remington);
  GaugeOptions options;
  options.longest = 0.4;
  const auto found = measured(record, rate, transfer, options);
  // Stretches overlap by half; what the last one leaves is shorter than that, and not seen.
  const std::size_t stretch = signals::fastLength(static_cast<std::size_t>(8 * 0.4 / 20 * rate));
  EXPECT_LE(found.length, 60 + 1e-9);
  EXPECT_GT(found.length, 60 - 0.5 * static_cast<double>(stretch) / rate * 20);
  EXPECT_NEAR(found.speed, 20, 1e-9);  // rounding of positions, 7e-15 m in 0.1 s, and of sums
  EXPECT_EQ(found.left, 0);
  // The levels of the very heights, through windows of the same length.
  const auto bands = wavelengthBands(0.01, 0.4);
  signals::PowerSpectrumOptions welch;
  welch.detrend = signals::Detrend::linear;
  welch.segment = stretch;
  auto levels = bandSquares(signals::powerSpectrum({0, 1 / rate, record.height, {}, {}}, welch), bands, 20);
  for (double& level : levels) level = levelOfSquare(level);
  ASSERT_EQ(found.levels.size(), bands.size());
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const auto& level = found.levels[i];
    EXPECT_NEAR(level.level, levels[i], bands[i].middle > 0.15 ? 0.5 : 0.2) << bands[i].middle;
    EXPECT_LT(level.lowest, level.level);
    EXPECT_GT(level.highest, level.level);
    EXPECT_NEAR(level.track, 1, 1e-9) << "half of 2 dB, which are the same at every frequency";
  }
  // More waves, narrower bounds.
  EXPECT_LT(found.levels.front().highest - found.levels.front().level,
            found.levels.back().highest - found.levels.back().level);
}

TEST(RoughnessGauge, GivesCorrugationBack) {
  constexpr double rate = 8192;
  const auto transfer = transferOfMass();
  const auto record = made(20, rate, 60, ContactFilter::none);
  GaugeOptions options;
  options.filter = ContactFilter::none;
  const auto found = measured(record, rate, transfer, options).corrugation;
  // The first and the last half of a stretch of 8 m are under a single window and do not count.
  const auto skipped = static_cast<std::ptrdiff_t>(4 / 20.0 * rate);
  const auto expected = corrugationIndices({record.height.begin() + skipped, record.height.end() - skipped}, 20 / rate);
  ASSERT_EQ(found.size(), 4u);
  // The longest waves differ most. leastOf() takes up to 3.6 % of them: at 1 m |H|^2 is a 36th of the band's mean. Here
  // up to 4 m more are seen at the end. From 0.3 to 1 m are 2.3 waves to a metre, so that 4 m have 19 degrees of
  // freedom: their power differs from the mean by 33 %, the root mean square of all 56 m by 1.2 %. Three times that is
  // allowed. Moving windows of 5 m (23 degrees of freedom: 15 %) begin at other places. The median of some ten of them
  // would scatter by 1.25 x 15 % / sqrt(10) = 6 % if they had nothing in common; twice that is allowed.
  for (std::size_t b = 0; b < 4; ++b) {
    EXPECT_NEAR(found[b].rms / expected[b].rms, 1, 0.08) << b;
    EXPECT_NEAR(found[b].typical / expected[b].typical, 1, 0.15) << b;
  }
}

// A speed of its own in every stretch: another frequency for the same wave.
TEST(RoughnessGauge, FollowsTheSpeed) {
  constexpr double rate = 8192;
  const auto transfer = transferOfMass();
  GaugeOptions options;
  options.longest = 0.25;
  RoughnessGauge gauge(transfer, rate, options);
  for (const double speed : {12.0, 22.0}) {
    const auto record = made(speed, rate, 40, ContactFilter::remington);
    gauge.add(record.acceleration, std::vector<double>(record.acceleration.size(), speed));
    gauge.breakHere();
  }
  const auto found = gauge.finish();
  for (const auto& level : found.levels) {
    const double expected = scenario::levelAt({{0.01, -8}, {0.04, -3.2}, {0.4, 17.1}}, level.band.middle);
    // Of two times 40 m, in expectation: what chance does to 80 m of waves, as the bounds say it. Beside it 0.2 dB of
    // lines with a width, as above, and 0.04 dB of the spectrum's slope, 20 dB a decade, within a third of an octave.
    EXPECT_GT(expected, level.lowest - 0.3) << level.band.middle;
    EXPECT_LT(expected, level.highest + 0.3) << level.band.middle;
  }
}

TEST(RoughnessGauge, LeavesOutWhatItCannotUse) {
  constexpr double rate = 8192;
  const auto transfer = transferOfMass();
  auto record = made(20, rate, 30, ContactFilter::remington);
  GaugeOptions options;
  options.longest = 0.1;
  for (std::size_t i = 4000; i < 4010; ++i) record.acceleration[i] = std::nan("");
  const auto found = measured(record, rate, transfer, options);
  EXPECT_GT(found.left, 0);
  for (const auto& level : found.levels) EXPECT_TRUE(std::isfinite(level.level)) << level.band.middle;
  RoughnessGauge standing(transfer, rate, options);
  standing.add(record.acceleration, std::vector<double>(record.acceleration.size(), 0.1));
  const auto nothing = standing.finish();
  EXPECT_EQ(nothing.length, 0);
  EXPECT_TRUE(std::isnan(nothing.levels.front().level));
}

// Half the sampling rate, and the ends of the transfer function.
TEST(RoughnessGauge, EndsWhereTheRecordDoes) {
  constexpr double rate = 2048;
  const auto transfer = transferOfMass();
  const auto record = made(20, rate, 30, ContactFilter::remington);
  for (const auto& level : measured(record, rate, transfer, {}).levels)
    EXPECT_EQ(std::isfinite(level.level), 20 / level.band.shortest < 0.45 * rate) << level.band.middle;
}

// A stream that hands out blocks gives what the whole gives.
TEST(RoughnessGauge, DoesNotMindBlocks) {
  constexpr double rate = 8192;
  const auto transfer = transferOfMass();
  const auto record = made(20, rate, 30, ContactFilter::remington);
  const std::vector<double> speed(record.acceleration.size(), 20);
  RoughnessGauge whole(transfer, rate, {}), pieces(transfer, rate, {});
  whole.add(record.acceleration, speed);
  for (std::size_t i = 0; i < speed.size(); i += 1000) {
    const auto end = static_cast<std::ptrdiff_t>(std::min(speed.size(), i + 1000)),
               begin = static_cast<std::ptrdiff_t>(i);
    pieces.add({record.acceleration.begin() + begin, record.acceleration.begin() + end},
               {speed.begin() + begin, speed.begin() + end});
  }
  const auto one = whole.finish(), other = pieces.finish();
  for (std::size_t i = 0; i < one.levels.size(); ++i)
    EXPECT_TRUE(one.levels[i].level == other.levels[i].level ||
                (std::isnan(one.levels[i].level) && std::isnan(other.levels[i].level)));
  EXPECT_EQ(one.corrugation[0].rms, other.corrugation[0].rms);
}

}  // namespace
}  // namespace squat::roughness
