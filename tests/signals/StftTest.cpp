#include "signals/Stft.h"

#include "signals/Reference.h"
#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

constexpr double rate = 25000;

TEST(Stft, isSciPys) {
  const tests::Reference reference("scipy.txt");
  const TimeSeries series{0, 1 / rate, reference["input"], "reference", "m/s2"};
  const auto stft = shortTimeTransform(series, {Window::hann, 64, 16, 128});
  EXPECT_LT(tests::relativeDifference(stft.frequency, reference["stft_frequency"]), 1e-12);
  EXPECT_LT(tests::relativeDifference(stft.time, reference["stft_time"]), 1e-12);
  std::vector<double> real, imaginary;  // every sixth column is frozen
  for (std::size_t row = 0; row < stft.frequency.size(); ++row)
    for (std::size_t column = 0; column < stft.time.size(); column += 6) {
      real.push_back(stft.coefficients[stft.index(row, column)].real());
      imaginary.push_back(stft.coefficients[stft.index(row, column)].imag());
    }
  EXPECT_LT(tests::relativeDifference(real, reference["stft_real"]), 1e-12);
  EXPECT_LT(tests::relativeDifference(imaginary, reference["stft_imag"]), 1e-12);
}

// A tone of amplitude 3 on a bin: |S| = 1.5 there; the densities of a window integrate to its mean square, 4.5.
TEST(Stft, toneHasHalfItsAmplitude) {
  const auto series = sampled(
      2000, rate, [](double t) { return 3 * std::sin(2 * pi * rate / 32 * t); }, 0.2);
  const auto stft = shortTimeTransform(series, {Window::hann, 256, 100, 0});
  ASSERT_EQ(stft.time.size(), 18u);
  EXPECT_NEAR(stft.time[0], 0.2 + 128 / rate, 1e-12);
  for (std::size_t column = 0; column < stft.time.size(); ++column) {
    ASSERT_NEAR(std::abs(stft.coefficients[stft.index(8, column)]), 1.5, 1e-12);
    double power = 0;
    for (std::size_t row = 0; row < stft.frequency.size(); ++row)
      power += stft.density[stft.index(row, column)] * rate / 256;
    ASSERT_NEAR(power, 4.5, 1e-10);
  }
}

TEST(Stft, refusesBadInput) {
  const auto series = sampled(100, rate, [](double t) { return t; });
  EXPECT_THROW(shortTimeTransform(series, {Window::hann, 101, 10, 0}), SignalError);
  EXPECT_THROW(shortTimeTransform(series, {Window::hann, 50, 0, 0}), SignalError);
  EXPECT_THROW(shortTimeTransform(series, {Window::hann, 50, 10, 40}), SignalError);
  EXPECT_EQ(shortTimeTransform(series, {Window::hann, 100, 10, 0}).time.size(), 1u);
}

}  // namespace
}  // namespace squat::signals
