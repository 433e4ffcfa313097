#include "signals/Comparison.h"

#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

constexpr double rate = 25000;

Passage struck(double impact, double low, double high, double height, double start = 0) {
  return passageAtSpeed(sampled(
                            6000, rate,
                            [=](double time) {
                              const double t = time - start - impact;
                              return t < 0 ? 0.0
                                           : height * (std::exp(-t / 0.012) * std::sin(2 * pi * low * t) +
                                                       std::exp(-t / 0.008) * std::sin(2 * pi * high * t));
                            },
                            start),
                        30);
}

// The same record, later and half as high.
TEST(Comparison, scaledAndShiftedRecord) {
  const auto result = compare(struck(0.08, 300, 1034, 60), struck(0.1, 300, 1034, 30, 5.0));
  EXPECT_NEAR(result.shift, 5.02, 1e-7);
  EXPECT_NEAR(result.correlation, 1, 1e-6);
  EXPECT_NEAR(result.peakRatio, 2, 1e-3);
  EXPECT_NEAR(result.rmsRatio, 2, 1e-4);
  ASSERT_EQ(result.bandRatio.size(), 3u);
  for (const double ratio : result.bandRatio) EXPECT_NEAR(ratio, 4, 1e-3);
  ASSERT_GE(result.peaks.size(), 2u);
  for (const auto& pair : result.peaks) EXPECT_NEAR(pair.shift(), 0, 0.05);
  EXPECT_NEAR(result.densityRatio[100], 4, 0.01);
  EXPECT_EQ(result.axis.size(), result.difference.size());
  const auto row = comparisonRow(result);
  EXPECT_EQ(row[0].first, "peak ratio [-]");
}

// Exactly: whoever reads 0.9999 looks for a reason.
TEST(Comparison, aRecordIsItself) {
  const auto result = compare(struck(0.08, 300, 1034, 60), struck(0.08, 300, 1034, 60));
  EXPECT_EQ(result.peakRatio, 1);
  EXPECT_EQ(result.rmsRatio, 1);
  EXPECT_EQ(result.shift, 0);
  EXPECT_EQ(result.differencePeak, 0);
  EXPECT_NEAR(result.correlation, 1, 1e-12);
}

// A record of 2 kHz says nothing of 1000 to 1200 Hz: no ratio, not that of what the interpolation leaks.
TEST(Comparison, whatTheSlowerRecordCannotHoldHasNoRatio) {
  auto slow = struck(0.08, 300, 700, 60);
  auto& values = slow.series.values;
  for (std::size_t i = 0; 12 * i < values.size(); ++i) values[i] = values[12 * i];
  values.resize((values.size() + 11) / 12), slow.series.step *= 12;
  const auto result = compare(struck(0.08, 300, 700, 60), passageAtSpeed(slow.series, 30));
  for (std::size_t b = 0; b < result.bands.size(); ++b)
    EXPECT_EQ(std::isnan(result.bandRatio[b]), result.bands[b].high > rate / 24) << result.bands[b].name;
  EXPECT_TRUE(std::isnan(result.densityRatio.back()));
}

// Lines 300 -> 330 Hz and 1034 -> 1000 Hz. The window of 12.7 ms makes lines about 100 Hz wide whose flanks pull each
// other's maxima a little: 8 Hz.
TEST(Comparison, movedLines) {
  const auto result = compare(struck(0.08, 300, 1034, 60), struck(0.08, 330, 1000, 60));
  ASSERT_GE(result.peaks.size(), 2u);
  const auto& low = result.peaks[0].first < 600 ? result.peaks[0] : result.peaks[1];
  const auto& high = result.peaks[0].first < 600 ? result.peaks[1] : result.peaks[0];
  EXPECT_NEAR(low.shift(), -30, 8);
  EXPECT_NEAR(high.shift(), 34, 8);
}

// A defect on top of what the same track does without it: the difference is what the defect does.
TEST(Comparison, defectAgainstSmooth) {
  const auto sleeper = [](double t) { return 5 * std::sin(2 * pi * 50 * t) + std::sin(2 * pi * 777 * t); };
  auto smooth = passageAtSpeed(sampled(6000, rate, sleeper), 30);
  auto defect = struck(0.08, 300, 1034, 60);
  const auto alone = defect.series.values;
  for (std::size_t i = 0; i < alone.size(); ++i) defect.series.values[i] += smooth.series.values[i];
  ComparisonOptions options;
  options.align = false;
  for (const bool inPosition : {false, true}) {
    options.inPosition = inPosition;
    const auto result = compare(defect, smooth, options);
    EXPECT_EQ(result.shift, 0);
    ASSERT_EQ(result.difference.size(), alone.size());
    EXPECT_LT(tests::relativeDifference(result.difference, alone), 1e-9);
    EXPECT_GT(result.bandRatio[1], 100);
    EXPECT_NEAR(result.differencePeak, *std::max_element(alone.begin(), alone.end()), 1e-6);
  }
}

TEST(Comparison, refusesBadInput) {
  auto one = struck(0.08, 300, 1034, 60), other = one;
  other.series.unit = std::string("g");
  EXPECT_THROW(compare(one, other), SignalError);
  other = one;
  other.position.pop_back();
  EXPECT_THROW(compare(one, other), SignalError);
  other = struck(0.08, 300, 1034, 60, 50.0);
  ComparisonOptions options;
  options.align = false;
  EXPECT_THROW(compare(one, other, options), SignalError);
}

// Over time each record's wave goes with its own speed: the same 1034 Hz at 30 and 27 m/s are 29.0 and 26.1 mm.
TEST(Comparison, eachPassageHasItsOwnSpeed) {
  auto slower = struck(0.09, 300, 1034, 60);
  const auto result = compare(struck(0.08, 300, 1034, 60), passageAtSpeed(slower.series, 27));
  EXPECT_NEAR(result.firstFeatures.wavelengthByRidge, 30.0 / 1034, 0.002);
  EXPECT_NEAR(result.secondFeatures.wavelengthByRidge / result.firstFeatures.wavelengthByRidge, 0.9, 0.005);
}

// Without alignment over places whose steps shrink with the speed: the step of the spectra is that of the equal places.
TEST(Comparison, unequalPlacesArePutOnEqualSteps) {
  std::vector<double> speed;
  for (int i = 0; i < 6000; ++i) speed.push_back(30 - 0.002 * i);
  const auto passage = passageAtSpeed(struck(0.08, 300, 1034, 60).series, speed);
  ComparisonOptions options;
  options.align = false, options.inPosition = true;
  const auto result = compare(passage, passage, options);
  const double step = (passage.position.back() - passage.position.front()) / 5999;
  for (std::size_t i = 1; i < result.axis.size(); ++i) ASSERT_NEAR(result.axis[i] - result.axis[i - 1], step, 1e-9);
  EXPECT_NEAR(result.differencePeak, 0, 1e-9);
  auto still = passage;
  still.position[10] = still.position[9];
  EXPECT_THROW(compare(still, passage, options), SignalError);
}

}  // namespace
}  // namespace squat::signals
