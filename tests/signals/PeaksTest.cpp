#include "signals/Peaks.h"

#include "signals/Reference.h"
#include "signals/Signals.h"

namespace squat::signals {
namespace {

void expectSciPysPeaks(const tests::Reference& reference, const std::string& name, const std::vector<double>& values) {
  const auto peaks = findPeaks(values);
  std::vector<double> index, prominence, left, right;
  for (const auto& peak : peaks) {
    index.push_back(static_cast<double>(peak.index));
    prominence.push_back(peak.prominence);
    left.push_back(peak.left);
    right.push_back(peak.right);
  }
  EXPECT_EQ(index, reference["peaks_" + name + "_index"]);
  EXPECT_LT(tests::relativeDifference(prominence, reference["peaks_" + name + "_prominence"]), 1e-12);
  EXPECT_LT(tests::relativeDifference(left, reference["peaks_" + name + "_left"]), 1e-12);
  EXPECT_LT(tests::relativeDifference(right, reference["peaks_" + name + "_right"]), 1e-12);
}

TEST(Peaks, areSciPys) {
  const tests::Reference reference("scipy.txt");
  expectSciPysPeaks(reference, "smooth", reference["lowpass4"]);
  expectSciPysPeaks(reference, "plateau", reference["plateau"]);
}

TEST(Peaks, leastProminenceCounts) {
  const std::vector<double> values{0, 5, 4, 4.5, 1, 9, 0};
  EXPECT_EQ(findPeaks(values).size(), 3u);
  const auto strong = findPeaks(values, 1.0);
  ASSERT_EQ(strong.size(), 2u);
  EXPECT_DOUBLE_EQ(strong[0].prominence, 4.0);  // parted from the 9 by the valley of 1
  EXPECT_DOUBLE_EQ(strong[1].prominence, 9.0);
}

TEST(Peaks, flatAndShortSignalsHaveNone) {
  EXPECT_TRUE(findPeaks({}).empty());
  EXPECT_TRUE(findPeaks({1.0}).empty());
  EXPECT_TRUE(findPeaks({1.0, 2.0}).empty());
  EXPECT_TRUE(findPeaks(std::vector<double>(50, 3.0)).empty());
  EXPECT_TRUE(findPeaks({0, 1, 2, 3, 3}).empty());
}

// A parabola's vertex between the samples is found exactly.
TEST(Peaks, spectralPeaksLieBetweenBins) {
  PowerSpectrum spectrum;
  for (int k = 0; k <= 100; ++k) {
    const double f = 10.0 * k;
    spectrum.frequency.push_back(f);
    spectrum.density.push_back(std::max(0.0, 4 - (f - 303) * (f - 303) / 400) +
                               std::max(0.0, 1 - (f - 808) * (f - 808) / 900));
  }
  const auto peaks = spectralPeaks(spectrum, 50, 2000);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_NEAR(peaks[0].frequency, 303, 1e-9);
  EXPECT_NEAR(peaks[0].density, 4, 1e-12);
  EXPECT_NEAR(peaks[1].frequency, 808, 1e-9);
  EXPECT_EQ(spectralPeaks(spectrum, 500, 2000).size(), 1u);
  EXPECT_EQ(spectralPeaks(spectrum, 50, 2000, 0.5).size(), 1u);
}

}  // namespace
}  // namespace squat::signals
