#include "signals/Features.h"

#include "signals/Reference.h"
#include "signals/SignalError.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

using tests::pi;
using tests::sampled;

constexpr double rate = 25000;

// Two oscillators struck by a pulse, by SciPy's lsim; the script beside the numbers says how each feature was made.
class FrozenSignal : public testing::Test {
 protected:
  const tests::Reference reference_{"features.txt"};
  const TimeSeries series_{0, 1 / rate, reference_["signal"], "two oscillators", "m/s2"};
  const Features features_ = features(series_);
};

TEST_F(FrozenSignal, timeDomain) {
  EXPECT_NEAR(features_.impactTime, reference_.scalar("impact"), 1e-12);
  EXPECT_NEAR(features_.peak, reference_["peak"][0], 1e-12 * 115);
  EXPECT_NEAR(features_.maximum, reference_["peak"][1], 1e-12 * 115);
  EXPECT_NEAR(features_.minimum, reference_["peak"][2], 1e-12 * 115);
  EXPECT_NEAR(features_.peakToPeak, features_.maximum - features_.minimum, 1e-12);
  EXPECT_NEAR(features_.rms, reference_["peak"][3], 1e-12 * 115);
  EXPECT_NEAR(features_.largestMovingRms, reference_.scalar("moving_rms"), 1e-11 * 115);
}

TEST_F(FrozenSignal, bandPowersAndPeaks) {
  ASSERT_EQ(features_.bands.size(), 3u);
  const std::string names[3] = {"power_130", "power_200", "power_1000"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = reference_.scalar(names[i]);
    // The script integrates the same broken line by a fine trapezoid rule: 1e-5.
    EXPECT_NEAR(features_.bands[i].power, expected, 1e-5 * expected) << names[i];
  }
  EXPECT_NEAR(features_.spectrum.integral, reference_.scalar("integral"), 1e-10 * features_.spectrum.integral);
  ASSERT_GE(features_.peaks.size(), 2u);
  // A window of 12.7 ms resolves about 120 Hz; the lines stand alone, so they lie within a tenth of that.
  std::vector<double> lines{features_.peaks[0].frequency, features_.peaks[1].frequency};
  std::sort(lines.begin(), lines.end());
  EXPECT_NEAR(lines[0], 300, 15);
  EXPECT_NEAR(lines[1], 1034, 15);
}

TEST_F(FrozenSignal, wavelengthAndDecay) {
  EXPECT_NEAR(features_.wavelengthByCrossings, reference_.scalar("wavelength_crossings"), 1e-9);
  EXPECT_NEAR(features_.wavelengthByRidge, reference_.scalar("wavelength_ridge"), 1e-9);
  // 30 m/s at 1034 Hz: 29.0 mm, the paper's mean wavelength; the pulse itself pulls the mean by a few percent.
  EXPECT_NEAR(features_.wavelengthByRidge, 0.0290, 0.0015);
  const std::string names[3] = {"decay_130", "decay_200", "decay_1000"};
  for (std::size_t i = 0; i < 3; ++i)  // within one sample
    EXPECT_NEAR(features_.bands[i].freeVibration, reference_.scalar(names[i]), 1.01 / rate) << names[i];
}

// exp(-t/T) struck at t0: the wavelet of scale s sees A(t) = exp(-t/T + (s/T)^2/2) erfc((s/T - t/s)/sqrt(2))/2, so the
// envelope is at a tenth of its largest value after T (ln 10 + (s/T)^2/2 - ln max A).
TEST(Features, freeVibrationOfADampedTone) {
  const double decay = 0.02, start = 0.05, scale = 6 / (2 * pi * 1095);
  const auto series = sampled(6000, rate, [&](double t) {
    return t < start ? 0.0 : std::exp(-(t - start) / decay) * std::sin(2 * pi * 1095 * (t - start));
  });
  double largest = 0;
  for (double t = 0; t < decay; t += 1e-5)
    largest = std::max(largest, std::exp(-t / decay + scale * scale / (2 * decay * decay)) * 0.5 *
                                    std::erfc((scale / decay - t / scale) / std::sqrt(2.0)));
  const double expected = decay * (std::log(10) + scale * scale / (2 * decay * decay) - std::log(largest));
  // The voices of the band that lie beside the tone see the sudden start a little more strongly: 1 % of T.
  EXPECT_NEAR(freeVibration(series, start, {"", 1000, 1200}, 0.1).duration, expected, 0.01 * decay);
}

// A tone that still rings when the record ends lasts at least that long; how long is not known.
TEST(Features, freeVibrationBeyondTheRecordIsNotANumber) {
  const auto series =
      sampled(3000, rate, [](double t) { return t < 0.05 ? 0.0 : std::sin(2 * pi * 300 * (t - 0.05)); });
  FeatureOptions options;
  options.anchor = Anchor{0.05};
  const auto bands = features(series, options).bands;
  EXPECT_TRUE(std::isnan(bands[1].freeVibration));
  EXPECT_NEAR(bands[1].ringsFor, 0.07,
              0.002);  // to the record's end at 0.12 s, less what its end takes from the wavelet
}

TEST(Features, wavelengthOfAPureTone) {
  const auto series = sampled(5000, rate, [](double t) { return std::sin(2 * pi * 1000 * t + 0.2); });
  // Linear interpolation between 25 samples a period: crossings within 1e-3 of a period.
  EXPECT_NEAR(wavelengthByCrossings(series, 0.05, 0.055, 30, {"", 600, 2000}), 0.030, 5e-5);
  EXPECT_NEAR(wavelengthByRidge(series, 0.05, 0.055, 30, {"", 600, 2000}), 0.030, 5e-5);
  EXPECT_TRUE(
      std::isnan(wavelengthByCrossings(series, 0.05, 0.0504, 30, {"", 600, 2000})));  // less than three crossings
}

TEST(Features, movingRmsOfAToneIsItsRms) {
  const auto series = sampled(1000, rate, [](double t) { return 2 * std::sin(2 * pi * 500 * t); });
  const auto moving = movingRms(series.values, 100);  // two periods
  for (std::size_t i = 60; i < 940; ++i) ASSERT_NEAR(moving[i], std::sqrt(2.0), 1e-9);
}

TEST(Features, rowHasNamesAndNumbers) {
  const auto series = sampled(3000, rate, [](double t) { return std::sin(2 * pi * 300 * t) * std::exp(-30 * t); });
  FeatureOptions options;
  options.bands = {{"my band", 250, 350}};
  const auto row = featureRow(features(series, options), 1);
  ASSERT_EQ(row.size(), 10u + 2 * 1 + 1 * 3 + 2);
  EXPECT_EQ(row[2].first, "peak [m/s2]");
  EXPECT_EQ(row[10].first, "power my band [(m/s2)2]");
  for (const auto& [name, value] : row) EXPECT_TRUE(std::isfinite(value)) << name;
}

// A tone has one line: where a second would stand, no number does, nought least of all.
TEST(Features, peaksThatAreNotThereAreNotANumber) {
  const auto row = featureRow(features(sampled(6000, rate, [](double t) { return std::sin(2 * pi * 300 * t); })), 4);
  const auto valueOf = [&](const std::string& name) {
    const auto found = std::find_if(row.begin(), row.end(), [&](const auto& entry) { return entry.first == name; });
    return found == row.end() ? -1 : found->second;
  };
  EXPECT_NEAR(valueOf("peak 1 frequency [Hz]"), 300, 1);
  EXPECT_TRUE(std::isnan(valueOf("peak 2 frequency [Hz]")));
  EXPECT_TRUE(std::isnan(valueOf("peak 2 width [Hz]")));
}

// Bands that nobody asked for by name are left out of a slow record, with their places in the row kept.
TEST(Features, bandsAboveHalfTheRateAreNotANumber) {
  const auto series =
      sampled(2000, 1000, [](double t) { return t < 1 ? 0.0 : std::exp(-20 * (t - 1)) * std::sin(2 * pi * 200 * t); });
  const auto all = features(series);
  ASSERT_EQ(all.bands.size(), 3u);
  EXPECT_GT(all.bands[0].power, 0);
  EXPECT_TRUE(std::isnan(all.bands[2].power) && std::isnan(all.bands[2].freeVibration));
  EXPECT_TRUE(std::isnan(all.wavelengthByRidge) && std::isnan(all.wavelengthByCrossings));
  EXPECT_EQ(featureRow(all).size(),
            featureRow(features(sampled(3000, rate, [](double t) { return std::sin(2 * pi * 300 * t); }))).size());
}

TEST(Features, aSignalWithoutUnitSaysUnit) {
  auto series = sampled(3000, rate, [](double t) { return std::sin(2 * pi * 300 * t); });
  series.unit.clear();
  const auto row = featureRow(features(series), 1);
  EXPECT_EQ(row[2].first, "peak [unit]");
  EXPECT_EQ(row[10].first, "power 130-320 Hz [(unit)2]");
}

TEST(Features, refusesBadInput) {
  const auto series = sampled(3000, rate, [](double t) { return std::sin(2 * pi * 300 * t); });
  FeatureOptions options;
  options.speed = 0;
  EXPECT_THROW(features(series, options), SignalError);
  options = {};
  options.bands = {{"high", 1000, 13000}};
  try {
    features(series, options);
    FAIL() << "a band above half the rate was accepted";
  } catch (const SignalError& error) {
    EXPECT_STREQ(error.what(),
                 "the band 1000 to 13000 Hz needs a sampling rate above 26000 Hz; signal 'test' has 25000 Hz");
  }
  options = {};
  options.anchor = Anchor{5.0};
  EXPECT_THROW(features(series, options), SignalError);
  auto shortSeries = series;
  shortSeries.values.resize(20);
  EXPECT_THROW(features(shortSeries), SignalError);
  auto constant = series;
  constant.values.assign(3000, 0.0);
  EXPECT_THROW(features(constant), SignalError);
}

}  // namespace
}  // namespace squat::signals
