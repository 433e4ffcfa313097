// One signal, one set of numbers: a study, an analysis and a comparison of the same record.
#include <gmock/gmock.h>

#include <map>

#include "analysis/Analysis.h"
#include "analysis/AnalysisFiles.h"
#include "analysis/FeatureTable.h"
#include "analysis/FileComparison.h"
#include "analysis/Folder.h"
#include "signals/Butterworth.h"

namespace squat::analysis {
namespace {

using tests::Folder;

// Struck at the defect, 60 ms after the start, and with its largest value 80 mm behind it.
results::RunResult lateSwing() {
  results::RunResult run;
  run.speed = 30;
  results::Channel aba{"aba", "m/s2", "", {}};
  for (int i = 0; i < 4000; ++i) {
    const double t = i / 25000.0, since = t - 0.06, later = since - 0.08 / 30;
    const double first = since < 0 ? 0 : 60 * std::exp(-since / 0.01) * std::sin(2 * M_PI * 334 * since);
    const double second = later < 0 ? 0 : 90 * std::exp(-later / 0.004) * std::sin(2 * M_PI * 749 * later);
    run.time.push_back(t);
    run.position.push_back(30.03 * t - 1.8018);  // under torque a little faster than the nominal 30 m/s
    aba.values.push_back(first + second + 0.1 * std::sin(400 * t));
  }
  auto filtered = aba;
  filtered.name = "aba_filtered";
  filtered.values = signals::lowPass({0, 1 / 25000.0, aba.values, "aba", "m/s2"}, 2000).values;
  run.signals = {aba, filtered};
  return run;
}

std::string tableOf(const results::RunResult& run) {
  std::ostringstream text;
  text << std::setprecision(17) << "time [s],position [m],aba [m/s2]\n";
  for (std::size_t i = 0; i < run.time.size(); ++i)
    text << run.time[i] << ',' << run.position[i] << ',' << run.signals[0].values[i] << '\n';
  return text.str();
}

using Row = std::vector<std::pair<std::string, double>>;
void expectSame(const Row& one, const Row& other, const std::string& what, double share = 1e-6, double seconds = 0) {
  const std::map<std::string, double> values(other.begin(), other.end());
  for (const auto& [name, value] : one) {
    const auto found = values.find(name);
    ASSERT_NE(found, values.end()) << what << ": " << name;
    if (std::isnan(value) && std::isnan(found->second)) continue;
    const double allowed = share * std::abs(value) + (name.ends_with("[s]") ? seconds : 0);
    EXPECT_NEAR(found->second, value, allowed) << what << ": " << name;
  }
}

TEST(OneDefinition, studyAnalysisAndComparisonGiveTheSameFeatures) {
  const Folder folder;
  const auto run = lateSwing();
  const auto file = folder.write("run.csv", tableOf(run));
  Monitor monitor;
  const auto study = featureTable(run);
  const auto analysis = analyse({file}, {}, monitor);
  const auto& signal = analysis.signals.at(0);
  EXPECT_NEAR(signal.features.impactTime, 0.06, 1e-9);  // 1.8018 m at 30.03 m/s, not 80 mm later
  EXPECT_EQ(signal.features.anchor, signals::AnchorRule::defect);
  // The same arithmetic on numbers that went through a table of 17 digits; the step of its times has lost some: 1e-6.
  expectSame(study, signals::featureRow(signal.features), "analyse");
  const auto pairs = compareFiles(file, {file}, {}, monitor);
  expectSame(study, signals::featureRow(pairs.at(0).comparison.firstFeatures), "compare, first");
  // The second has its anchor where correlation puts it, to a fortieth of a sample (1e-6 s); the stretch whose waves
  // are averaged, 5 ms, shifts by as much.
  expectSame(study, signals::featureRow(pairs.at(0).comparison.secondFeatures), "compare, second", 2e-4, 1e-6);
  // The largest value is where a swing of 90 begins 80 mm behind: an anchor there would not be 0.06 s.
  EXPECT_GT(std::abs(signal.filtered.timeAt(signals::largestSample(signal.filtered.values)) - 0.06), 0.002);
}

TEST(OneDefinition, theAnchorIsNamedInTheTables) {
  const Folder folder;
  Monitor monitor;
  const auto analysis = analyse({folder.write("run.csv", tableOf(lateSwing()))}, {}, monitor);
  EXPECT_THAT(featureCsv(analysis), testing::HasSubstr("file,run,anchor,"));
  EXPECT_THAT(featureCsv(analysis), testing::HasSubstr(",defect at position 0,"));
  EXPECT_THAT(featureJson(analysis), testing::HasSubstr("\"anchor\": \"defect at position 0\""));
}

// 40 s of noise around one strike: the map of the stretch around it is that of a second cut out.
TEST(OneDefinition, theScalogramOfALongRecordIsThatOfACut) {
  const double rate = 5000, strike = 20;
  signals::Record longOne;
  longOne.signals = {{"aba", "m/s2", "", {}}};
  for (int i = 0; i < 200000; ++i) {
    const double t = i / rate, since = t - strike;
    longOne.time.push_back(t);
    longOne.signals[0].values.push_back(
        0.1 * std::sin(777 * t) + (since < 0 ? 0 : 50 * std::exp(-since / 0.005) * std::sin(2 * M_PI * 400 * since)));
    longOne.position.push_back(30 * t);
  }
  auto cut = longOne;
  for (auto* values : {&cut.time, &cut.position, &cut.signals[0].values})
    *values = {values->begin() + 97500, values->begin() + 102500};
  const auto all = analyseSignal(longOne, {}), part = analyseSignal(cut, {});
  const auto& one = all.scalogram.power;
  const auto& other = part.scalogram.power;
  ASSERT_FALSE(one.empty());
  ASSERT_EQ(one.size(), other.size());
  const double top = *std::max_element(other.begin(), other.end());
  // The cut's ends lie 0.5 s off, 25 lengths of the longest wavelet: only the filter's start there differs.
  EXPECT_NEAR(*std::max_element(one.begin(), one.end()), top, 1e-6 * top);
  EXPECT_GE(all.scalogramPosition.front(), -0.1 - 1e-9);
  EXPECT_LE(all.scalogramPosition.back(), 0.28 + 1e-9);
}

// Titles as they were written down by hand; whichever form of the name a file or a table has, they are the same.
TEST(FeatureTitle, isInWordsForColumnsAndForFeaturesOfAResult) {
  for (const auto& [name, title] : std::map<std::string, std::string>{
           {"peak [m/s2]", "Largest acceleration, up or down"},
           {"peak_to_peak", "Largest less smallest acceleration"},
           {"peak 2 frequency [Hz]", "Line 2 of the spectrum"},
           {"peak_1_prominence", "Prominence of line 1"},
           {"wavelength by crossings [m]", "Wavelength behind the defect, by zero crossings"},
           {"power_200-400_Hz", "Power, 200-400 Hz"},
           {"free vibration 1000-1200 Hz [s]", "Free vibration, 1000-1200 Hz"},
           {"right_smallest_contact_force", "Smallest contact force, of the right wheel"},
           {"what_nobody_knows [m]", "what nobody knows"}})
    EXPECT_EQ(featureTitle(name), title);
}

// A feature that the catalogue lacks would be printed under its name.
TEST(FeatureTitle, isThereForEveryFeatureOfARun) {
  const auto features = featureScalars(lateSwing());
  EXPECT_GT(features.size(), 20U);
  for (const auto& feature : features) {
    const auto title = featureTitle(feature.name);
    EXPECT_EQ(title.find('_'), std::string::npos) << title;
    EXPECT_TRUE(title[0] >= 'A' && title[0] <= 'Z') << title;
    EXPECT_FALSE(feature.description.empty()) << feature.name;
  }
}

}  // namespace
}  // namespace squat::analysis
