#include "signals/PowerSpectrum.h"

#include <random>

#include "signals/Reference.h"
#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::relativeDifference;
using tests::sampled;

constexpr double rate = 25000;

TimeSeries referenceInput(const tests::Reference& reference) {
  return {0, 1 / rate, reference["input"], "reference", "m/s2"};
}

TEST(PowerSpectrum, welchIsSciPys) {
  const tests::Reference reference("scipy.txt");
  const auto series = referenceInput(reference);
  for (const auto window : {Window::boxcar, Window::hann, Window::hamming, Window::blackman}) {
    const auto spectrum = powerSpectrum(series, {window, Detrend::constant, 128, 0.5, 0});
    EXPECT_LT(relativeDifference(spectrum.density, reference["welch_" + toText(window)]), 1e-12) << toText(window);
    EXPECT_EQ(spectrum.segments, 5u);
  }
  const auto padded = powerSpectrum(series, {Window::hann, Detrend::linear, 101, 25.0 / 101, 256});
  EXPECT_LT(relativeDifference(padded.density, reference["welch_padded"]), 1e-12);
  EXPECT_LT(relativeDifference(powerSpectrum(series, {Window::boxcar, Detrend::none, 0, 0, 0}).density,
                               reference["periodogram"]),
            1e-12);
  EXPECT_LT(relativeDifference(powerSpectrum(series, {Window::hann, Detrend::linear, 0, 0, 0}).density,
                               reference["periodogram_linear"]),
            1e-12);
}

// Parseval: exact for a boxcar without overlap, for even and odd lengths.
TEST(PowerSpectrum, integralIsTheMeanSquare) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.7, 3.0);
  for (const std::size_t n : {1000u, 1001u}) {
    const auto series = sampled(n, rate, [&](double) { return normal(random); });
    double meanSquare = 0;
    for (const double value : series.values) meanSquare += value * value / static_cast<double>(n);
    const auto spectrum = powerSpectrum(series, {Window::boxcar, Detrend::none, 0, 0, 0});
    EXPECT_NEAR(spectrum.integral, meanSquare, 1e-12 * meanSquare);
    EXPECT_NEAR(spectrum.meanSquare, meanSquare, 1e-12 * meanSquare);
  }
}

// White noise of variance s^2 has the density 2 s^2/rate. With about 800 half-overlapping Hann segments the average's
// standard deviation over all bins is far below the 2 % allowed; single bins scatter by 1/sqrt(800 * 0.95) = 3.6 %.
TEST(PowerSpectrum, whiteNoiseHasItsVariance) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0, 3.0);
  const auto series = sampled(409600, rate, [&](double) { return normal(random); });
  const auto spectrum = powerSpectrum(series, {Window::hann, Detrend::constant, 1024, 0.5, 0});
  EXPECT_NEAR(spectrum.integral, 9.0, 0.02 * 9.0);
  EXPECT_NEAR(spectrum.integral, spectrum.meanSquare, 0.02 * 9.0);
  for (std::size_t k = 5; k + 5 < spectrum.density.size(); ++k)
    ASSERT_NEAR(spectrum.density[k], 2 * 9.0 / rate, 6 * 0.036 * 2 * 9.0 / rate) << k;  // six standard deviations
}

// A tone of amplitude a on a bin: power a^2/2, all of it within one bin to each side with Hann.
TEST(PowerSpectrum, toneHasHalfItsAmplitudeSquared) {
  const double frequency = 40 * rate / 1000;
  const auto series = sampled(1000, rate, [&](double t) { return 5 * std::cos(2 * pi * frequency * t + 1); });
  const auto spectrum = powerSpectrum(series, {Window::hann, Detrend::none, 0, 0, 0});
  EXPECT_NEAR((spectrum.density[39] + spectrum.density[40] + spectrum.density[41]) * spectrum.step(), 12.5, 1e-10);
  EXPECT_NEAR(spectrum.frequency[40], frequency, 1e-9);
  EXPECT_EQ(spectrum.window, "hann, 1000 samples, detrend none");
}

// An impulse of height h has a flat spectrum: h^2/n in all, equally over the frequencies up to half the rate.
TEST(PowerSpectrum, impulseIsFlat) {
  auto series = sampled(512, rate, [](double) { return 0.0; });
  series.values[100] = 7;
  const auto spectrum = powerSpectrum(series, {Window::boxcar, Detrend::none, 0, 0, 0});
  for (std::size_t k = 1; k + 1 < spectrum.density.size(); ++k)
    ASSERT_NEAR(spectrum.density[k], 2 * 49.0 / (512 * rate), 1e-15);
}

TEST(PowerSpectrum, bandPowerIntegratesPartsOfBins) {
  PowerSpectrum spectrum;
  spectrum.frequency = {0, 10, 20, 30};
  spectrum.density = {0, 1, 3, 3};
  EXPECT_NEAR(bandPower(spectrum, 0, 30), 5 + 20 + 30, 1e-12);
  EXPECT_NEAR(bandPower(spectrum, 15, 25), 0.5 * (2 + 3) * 5 + 15, 1e-12);
  EXPECT_THROW(bandPower(spectrum, 15, 31), SignalError);
  EXPECT_THROW(bandPower(spectrum, 15, 15), SignalError);
}

TEST(PowerSpectrum, cutOutTakesSamplesBetweenTheTimes) {
  const auto series = sampled(
      101, 1000, [](double t) { return t; }, -0.05);
  const auto part = cutOut(series, 0.0, 0.01);
  ASSERT_EQ(part.values.size(), 11u);
  EXPECT_NEAR(part.start, 0, 1e-15);
  EXPECT_NEAR(part.values.back(), 0.01, 1e-15);
  EXPECT_THROW(cutOut(series, 1, 2), SignalError);
  EXPECT_EQ(cutOut(series, -10, 10).values.size(), 101u);
}

TEST(PowerSpectrum, refusesBadInput) {
  const auto tone = sampled(100, rate, [](double t) { return std::sin(500 * t); });
  auto holed = tone;
  holed.values[17] = std::nan("");
  try {
    powerSpectrum(holed);
    FAIL() << "a gap was accepted";
  } catch (const SignalError& error) {
    EXPECT_EQ(error.sample(), 17u);
    EXPECT_STREQ(error.what(), "signal 'test': sample 17 is not a finite number");
  }
  auto constant = tone;
  constant.values.assign(100, 4.0);
  EXPECT_THROW(powerSpectrum(constant), SignalError);
  EXPECT_THROW(powerSpectrum(tone, {Window::hann, Detrend::none, 101, 0.5, 0}), SignalError);
  EXPECT_THROW(powerSpectrum(tone, {Window::hann, Detrend::none, 50, 1.0, 0}), SignalError);
  EXPECT_THROW(powerSpectrum(tone, {Window::hann, Detrend::none, 50, 0.5, 49}), SignalError);
  EXPECT_THROW(windowFromText("kaiser"), SignalError);
  EXPECT_EQ(windowFromText("blackman"), Window::blackman);
}

}  // namespace
}  // namespace squat::signals
