#include "signals/ContinuousWavelet.h"

#include <mutex>

#include "signals/Reference.h"
#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

constexpr double rate = 25000;
constexpr auto energy = WaveletNormalisation::energy;
constexpr auto amplitude = WaveletNormalisation::amplitude;

// The reference sums equation 1 over the samples. The transform cuts the wavelet at 9e-11 of its peak.
TEST(ContinuousWavelet, agreesWithDirectQuadrature) {
  const tests::Reference reference("scipy.txt");
  const TimeSeries series{0, 1 / rate, reference["input"], "reference", "m/s2"};
  for (const double frequency : {150.0, 311.0, 1034.0, 2500.0, 5000.0}) {
    for (const auto kind : {energy, amplitude}) {
      const std::string name = std::string("cwt_") + (kind == energy ? "energy_" : "amplitude_") +
                               std::to_string(static_cast<int>(frequency));
      const auto coefficients = waveletCoefficients(series, frequency, kind);
      const std::size_t samples[5] = {0, 37, 200, 333, 400};
      std::vector<double> real, imaginary;
      for (const std::size_t i : samples) {
        real.push_back(coefficients[i].real());
        imaginary.push_back(coefficients[i].imag());
      }
      EXPECT_LT(tests::relativeDifference(real, reference[name + "_real"]), 1e-9) << name;
      EXPECT_LT(tests::relativeDifference(imaginary, reference[name + "_imag"]), 1e-9) << name;
    }
  }
}

// Ridge at the tone within half a voice; amplitude-normalised: 1 within 1 %; energy: |W|^2 in closed form,
// |1/2 sqrt(s) pi^(-1/4) sqrt(2 pi) exp(-(s w - w0)^2/2)|^2.
TEST(ContinuousWavelet, toneHasItsRidge) {
  for (const double frequency : {97.0, 300.0, 1034.0, 1900.0, 8000.0}) {
    const auto tone = sampled(8192, rate, [&](double t) { return std::cos(2 * pi * frequency * t + 0.4); });
    for (const auto kind : {energy, amplitude}) {
      const auto map = scalogram(tone, {40, 12000, 24, kind, 1, 1});
      const std::size_t middle = 4096;
      ASSERT_LT(map.coneOfInfluence[middle], frequency);
      std::size_t best = 0;
      for (std::size_t row = 0; row < map.frequency.size(); ++row)
        if (map.at(row, middle) > map.at(best, middle)) best = row;
      EXPECT_LT(std::abs(std::log2(map.frequency[best] / frequency)), 0.5 / 24) << frequency;
      if (kind == amplitude) {
        EXPECT_NEAR(std::sqrt(map.at(best, middle)), 1.0, 0.01) << frequency;
      }
    }
    const double scale = waveletScale(frequency, energy);
    const double distance = scale * 2 * pi * frequency - 6;
    const double expected = 0.25 * scale * 2 * std::sqrt(pi) * std::exp(-distance * distance);
    EXPECT_NEAR(std::norm(waveletCoefficients(tone, frequency, energy)[4096]), expected, 1e-6 * expected);
  }
}

// An impulse of one sample: W = 1/sqrt(s) psi*((t0 - tau)/s) h dt, so |W|^2 falls to exp(-2) at a distance of sqrt(2)
// s, which is how the cone of influence is drawn.
TEST(ContinuousWavelet, impulseIsTheWavelet) {
  auto series = sampled(2001, rate, [](double) { return 0.0; });
  series.values[1000] = 3;
  const double frequency = 1000, scale = waveletScale(frequency, energy);
  const auto coefficients = waveletCoefficients(series, frequency, energy);
  for (std::size_t i = 900; i <= 1100; ++i) {
    const double u = (static_cast<double>(i) - 1000) / rate / scale;
    const double expected = 3 / rate / std::sqrt(scale) * std::exp(-u * u / 2) / std::sqrt(std::sqrt(pi));
    ASSERT_NEAR(std::abs(coefficients[i]), expected, 1e-8 * 3 / rate / std::sqrt(scale)) << i;
  }
  const auto cone = coneOfInfluence({0.0, std::numbers::sqrt2 * scale, 0.05}, 0.0, 1.0, rate, energy);
  EXPECT_DOUBLE_EQ(cone[0], rate / 2);
  EXPECT_NEAR(cone[1], frequency, 1e-9 * frequency);
  EXPECT_LT(cone[2], cone[1]);
}

// A linear chirp: the ridge follows its momentary frequency within half a voice where the chirp is slow
// (frequency change over the wavelet's length below a voice).
TEST(ContinuousWavelet, chirpHasItsRidge) {
  const double from = 200, to = 2000, length = 1.0;
  const auto chirp = sampled(
      25000, rate, [&](double t) { return std::sin(2 * pi * (from * t + 0.5 * (to - from) / length * t * t)); });
  const auto map = scalogram(chirp, {100, 4000, 16, amplitude, 1, 1});
  for (std::size_t column = 2500; column < 22500; column += 500) {
    const double momentary = from + (to - from) * map.time[column] / length;
    std::size_t best = 0;
    for (std::size_t row = 0; row < map.frequency.size(); ++row)
      if (map.at(row, column) > map.at(best, column)) best = row;
    ASSERT_LT(std::abs(std::log2(map.frequency[best] / momentary)), 0.55 / 16) << momentary;
    ASSERT_NEAR(std::sqrt(map.at(best, column)), 1.0, 0.02) << momentary;
  }
}

// Many blocks, strides and threads give the coefficients of one single block.
TEST(ContinuousWavelet, blocksAndStridesJoin) {
  const auto series = sampled(200000, rate, [](double t) {
    return std::sin(2 * pi * 300 * t * (1 + 0.2 * std::sin(9 * t))) + 0.5 * std::cos(2 * pi * 1034 * t) +
           0.1 * std::sin(2 * pi * 40 * t);
  });
  const std::vector<double> frequencies{30, 60, 300, 1034, 5000};
  std::vector<std::vector<std::complex<double>>> joined(frequencies.size());
  std::vector<std::size_t> strides(frequencies.size());
  transformInBlocks(series, frequencies, amplitude, 1 << 20, 2, [&](const WaveletPart& part) {
    auto& voice = joined[part.voice];
    voice.resize((series.values.size() + part.stride - 1) / part.stride, {1e300, 0});
    strides[part.voice] = part.stride;
    ASSERT_EQ(part.first % part.stride, 0u);
    for (std::size_t i = 0; i < part.coefficients.size(); ++i)
      voice[part.first / part.stride + i] = part.coefficients[i];
  });
  EXPECT_GT(strides[0], 64u);
  EXPECT_EQ(strides[4], 2u);
  // Reference: the direct sum of equation 1 at some samples, in this test.
  for (std::size_t v = 0; v < frequencies.size(); ++v) {
    const double scale = waveletScale(frequencies[v], amplitude);
    for (std::size_t k = 3; k < joined[v].size(); k += joined[v].size() / 23) {
      const double centre = static_cast<double>(k * strides[v]);
      std::complex<double> sum = 0;
      for (std::size_t i = 0; i < series.values.size(); ++i) {
        const double u = (static_cast<double>(i) - centre) / rate / scale;
        if (std::abs(u) < 9) sum += series.values[i] * std::polar(std::exp(-u * u / 2), -6 * u);
      }
      sum *= std::sqrt(2 / pi) / rate / scale;
      ASSERT_LT(std::abs(joined[v][k] - sum), 1e-9) << frequencies[v] << " Hz, coefficient " << k;
    }
  }
}

// Columns of several samples hold the mean power, whatever the number of threads.
TEST(ContinuousWavelet, cellsHoldTheMean) {
  const auto series = sampled(40000, rate, [](double t) { return std::sin(2 * pi * 250 * t) * std::exp(-3 * t); });
  const auto fine = scalogram(series, {100, 1000, 4, energy, 1, 1});
  const auto coarse = scalogram(series, {100, 1000, 4, energy, 64, 1});
  const auto threaded = scalogram(series, {100, 1000, 4, energy, 64, 2});
  ASSERT_EQ(coarse.time.size(), 625u);
  EXPECT_EQ(coarse.power, threaded.power);
  EXPECT_NEAR(coarse.time[1], 95.5 / rate, 1e-12);
  for (std::size_t row = 0; row < fine.frequency.size(); ++row)
    for (std::size_t column = 20; column < 600; column += 7) {
      double mean = 0;
      for (std::size_t i = 0; i < 64; ++i) mean += fine.at(row, column * 64 + i) / 64;
      // The mean of 4 or more samples of |W|^2 instead of 64.
      ASSERT_NEAR(coarse.at(row, column), mean, 0.02 * mean + 1e-12);
    }
}

// Cells that two blocks share are sums: their bits must not depend on which thread was first.
TEST(ContinuousWavelet, partsOfAVoiceComeInOrder) {
  const auto series = sampled(300000, rate, [](double t) { return std::sin(2 * pi * 250 * t); });
  for (const int threads : {1, 3}) {
    std::vector<std::size_t> next(3, 0);
    transformInBlocks(series, {200, 400, 800}, energy, 16, threads, [&](const WaveletPart& part) {
      EXPECT_EQ(part.first, next[part.voice]) << threads << " threads";
      next[part.voice] = part.first + part.coefficients.size() * part.stride;
    });
    for (const std::size_t end : next) EXPECT_GE(end, 300000u);
  }
}

// A sink that throws ends the transform on every thread, with its own error.
TEST(ContinuousWavelet, aSinkThatThrowsIsHeard) {
  const auto series = sampled(300000, rate, [](double t) { return std::sin(2 * pi * 250 * t); });
  const auto sink = [](const WaveletPart& part) {
    if (part.first > 0) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(transformInBlocks(series, {200, 400, 800}, energy, 16, 3, sink), std::runtime_error);
}

TEST(ContinuousWavelet, refusesBadInput) {
  const auto tone = sampled(100, rate, [](double t) { return std::sin(500 * t); });
  EXPECT_THROW(scalogram(tone, {100, 12600, 12, energy, 1, 1}), SignalError);
  EXPECT_THROW(scalogram(tone, {0, 1000, 12, energy, 1, 1}), SignalError);
  EXPECT_THROW(scalogram(tone, {2000, 1000, 12, energy, 1, 1}), SignalError);
  EXPECT_THROW(scalogram(tone, {100, 1000, 0, energy, 1, 1}), SignalError);
  EXPECT_THROW(scalogram(TimeSeries{}, {}), SignalError);
  auto constant = tone;
  constant.values.assign(100, 1.0);
  EXPECT_THROW(scalogram(constant, {}), SignalError);
}

}  // namespace
}  // namespace squat::signals
