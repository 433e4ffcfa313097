// Slow: time and memory of long wavelet transforms.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <random>
#include <string>
#include <thread>

#include "signals/ContinuousWavelet.h"
#include "signals/FourierTransform.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Peak memory of this process [bytes].
double peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return 1024 * std::stod(line.substr(6));
  return 0;
}

TimeSeries noise(std::size_t n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return tests::sampled(n, 25000, [&](double) { return uniform(random); });
}

// One million samples, 100 voices (ten octaves up to half the rate), double precision, two threads, against 100
// full-length transforms of the same million on two threads, in turns so that a busy machine slows both. The better of
// three ratios counts: another process may take a core at any moment.
TEST(WaveletSpeed, againstFullLengthTransforms) {
  const auto series = noise(1000000);
  const auto frequencies = waveletFrequencies(12500 / std::exp2(9.9), 12500, 10);
  ASSERT_EQ(frequencies.size(), 100u);
  const ComplexTransform plan(series.values.size(), Direction::forward);
  double best = HUGE_VAL;
  for (int attempt = 0; attempt < 3; ++attempt) {
    double power = 0;
    const double wavelet = seconds([&] {
      transformInBlocks(series, frequencies, WaveletNormalisation::energy, 1 << 20, 2, [&](const WaveletPart& part) {
        for (const auto& coefficient : part.coefficients) power += std::norm(coefficient);
      });
    });
    EXPECT_GT(power, 0);
    const double transforms = seconds([&] {
      const auto half = [&] {
        std::vector<Complex> values(series.values.begin(), series.values.end());
        for (int i = 0; i < 50; ++i) {
          plan.inPlace(values.data());
          for (auto& value : values) value *= 1e-3;  // so that the numbers stay finite
        }
      };
      const std::jthread other(half);
      half();
    });
    best = std::min(best, wavelet / transforms);
  }
  RecordProperty("ratio", std::to_string(best));
  EXPECT_LT(best, 0.7);
}

// Ten million samples (80 MB), 60 voices: at full rate the scalogram would be 4.8 GB. The picture of it has 2000
// columns, and what is held besides is a few blocks.
TEST(WaveletSpeed, tenMillionSamplesInBlocks) {
  const auto series = noise(10000000);
  const double before = peakMemory();
  WaveletOptions options;
  options.lowest = 40;
  options.highest = 2500;
  options.voicesPerOctave = 10;
  options.cell = 5000;
  options.threads = 2;
  const auto map = scalogram(series, options);
  EXPECT_EQ(map.time.size(), 2000u);
  EXPECT_LT(peakMemory() - before, 100e6);
  // White noise of variance 1/3: mean power of a scale = variance * step (energy normalisation, |psi| of unit norm).
  for (std::size_t row = 0; row < map.frequency.size(); ++row) {
    double mean = 0;
    for (std::size_t column = 1; column + 1 < map.time.size(); ++column)
      mean += map.at(row, column) / static_cast<double>(map.time.size() - 2);
    // 400 s hold at least 400 s * 40 Hz / 6 = 2700 independent values at the lowest voice: 2 %; three times that.
    ASSERT_NEAR(mean, series.step / 3, 0.06 * series.step / 3) << map.frequency[row];
  }
}

}  // namespace
}  // namespace squat::signals
