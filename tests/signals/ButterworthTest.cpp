#include "signals/Butterworth.h"

#include "signals/Reference.h"
#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::relativeDifference;

constexpr double rate = 25000;
// Rounding of the recursion only: the definitions are SciPy's.
constexpr double tolerance = 1e-9;

TEST(Butterworth, forwardBackIsSciPys) {
  const tests::Reference reference("scipy.txt");
  const auto& input = reference["input"];
  EXPECT_LT(relativeDifference(filterForwardBack(butterworthLowPass(4, 2000, rate), input), reference["lowpass4"]),
            tolerance);
  EXPECT_LT(relativeDifference(filterForwardBack(butterworthLowPass(5, 3100, rate), input), reference["lowpass5"]),
            tolerance);
  EXPECT_LT(
      relativeDifference(filterForwardBack(butterworthBandPass(4, 600, 2000, rate), input), reference["bandpass4"]),
      tolerance);
  EXPECT_LT(
      relativeDifference(filterForwardBack(butterworthBandPass(3, 130, 320, rate), input), reference["bandpass3"]),
      tolerance);
  EXPECT_LT(
      relativeDifference(filterForwardBack(butterworthBandPass(1, 20, 12000, rate), input), reference["bandpass1wide"]),
      tolerance);
}

// |H|^2 = 1/(1 + (tan(pi f/rate)/tan(pi fc/rate))^(2 order)), the prewarped Butterworth response.
TEST(Butterworth, gainIsTheClosedForm) {
  const auto sections = butterworthLowPass(4, 2000, rate);
  for (const double f : {10.0, 500.0, 1999.0, 2000.0, 3500.0, 8000.0}) {
    const double ratio = std::tan(pi * f / rate) / std::tan(pi * 2000 / rate);
    EXPECT_NEAR(gainAt(sections, f, rate), 1 / std::sqrt(1 + std::pow(ratio, 8)), 1e-12) << f;
  }
}

// No delay: a tone in the pass band keeps its phase; -6 dB at the cut-off after both passes.
TEST(Butterworth, passesForwardAndBackWithoutDelay) {
  const auto tone = [](double f) {
    return tests::sampled(5000, rate, [f](double t) { return std::sin(2 * pi * f * t); });
  };
  const auto slow = tone(200), edge = tone(2000);
  const auto slowOut = lowPass(slow, 2000), edgeOut = lowPass(edge, 2000);
  // Away from the ends, where the reflection ends in a kink.
  for (std::size_t i = 1000; i < 4000; ++i) {
    ASSERT_NEAR(slowOut.values[i], slow.values[i], 1e-6);
    ASSERT_NEAR(edgeOut.values[i], 0.5 * edge.values[i], 1e-9);
  }
  EXPECT_EQ(slowOut.unit, "m/s2");
}

TEST(Butterworth, refusesEdgesOutsideTheRate) {
  EXPECT_THROW(butterworthLowPass(4, 12500, rate), SignalError);
  EXPECT_THROW(butterworthLowPass(4, 0, rate), SignalError);
  EXPECT_THROW(butterworthLowPass(0, 100, rate), SignalError);
  EXPECT_THROW(butterworthBandPass(4, 300, 200, rate), SignalError);
  EXPECT_THROW(filterForwardBack(butterworthLowPass(4, 2000, rate), std::vector<double>(15, 1.0)), SignalError);
  EXPECT_EQ(filterForwardBack(butterworthLowPass(4, 2000, rate), std::vector<double>(16, 1.0)).size(), 16u);
}

}  // namespace
}  // namespace squat::signals
