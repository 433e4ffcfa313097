// What a report says, before it is printed. Expected words and numbers were written by hand.
#include "project/ReportContent.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "analysis/FeatureTable.h"
#include "analysis/Folder.h"
#include "case/CaseDescription.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "project/ReportParts.h"

namespace squat::project {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Row = std::vector<std::string>;

// Struck at the defect, rings at 300 and 1000 Hz.
std::shared_ptr<results::RunResult> runOf(const cases::CaseDescription& description, double height = 80) {
  auto run = std::make_shared<results::RunResult>();
  run->stem = "light-defect", run->title = "Light defect", run->speed = 30, run->complete = true;
  results::Channel aba{"aba", "m/s2", "", {}}, force{"contact_force", "N", "", {}};
  for (int i = 0; i < 4000; ++i) {
    const double t = i / 25000.0, since = t - 0.06, late = std::max(since, 0.0);
    run->time.push_back(t);
    run->position.push_back(30 * since);
    aba.values.push_back(0.1 * std::sin(400 * t) +
                         height * (std::exp(-late / 0.01) * std::sin(2 * M_PI * 300 * late) +
                                   0.5 * std::exp(-late / 0.005) * std::sin(2 * M_PI * 1000 * late)));
    force.values.push_back(90e3 + 500 * aba.values.back());
  }
  auto filtered = aba;
  filtered.name = "aba_filtered";
  run->signals = {aba, filtered, force};
  results::setCase(*run, description);
  return run;
}

cases::CaseDescription caseWith(const std::vector<std::pair<std::string, std::string>>& values) {
  auto description = cases::defaultCase();
  for (const auto& [key, value] : values) cases::setValue(description, key, value);
  return description;
}

// Two runs on stiff pads, over dips of two depths.
Report twoRuns() {
  Report report;
  const auto shallow = runOf(caseWith({{"pad.stiffness", "2000"}, {"defect.depth", "0.2"}}), 40);
  const auto deep = runOf(caseWith({{"pad.stiffness", "2000"}, {"defect.depth", "0.4"}}), 80);
  report.signals = {{"shallow", "shallow.h5", shallow, shallow}, {"deep", "deep.h5", deep, deep, {}, true}};
  report.shown = report.reference = 0;
  return report;
}

ListedEvent squatAt(double position, const char* severity) {
  ListedEvent event;
  event.position = position, event.record = "/rides/day 1.csv", event.channel = "left";
  event.kind = "squat", event.severity = severity;
  event.sureness = 0.91, event.peak = 100, event.speed = 30;
  event.length = 0.045, event.lengthLow = 0.03, event.lengthHigh = 0.06;
  event.depth = 0.2e-3, event.depthLow = 0.1e-3, event.depthHigh = 0.3e-3;
  event.severities = {0.1, 0.7, 0.2};
  event.passes = 2, event.passesThere = 3;
  return event;
}

// Two squats and a joint between them.
Report ride() {
  Report report;
  auto joint = squatAt(200, "");
  joint.kind = "joint", joint.reason = "as labelled", joint.severities = {};
  report.events = {{"/rides/day 1.csv"}, {squatAt(12345.678, "moderate"), joint, squatAt(400, "severe")}};
  return report;
}

ReportContent contentOf(const Report& report) {
  std::vector<std::string> problems;
  auto content = reportContent(report, problems);
  EXPECT_THAT(problems, IsEmpty());
  return content;
}

const Row* rowNamed(const ReportTable& table, const std::string& name) {
  const auto found =
      std::find_if(table.rows.begin(), table.rows.end(), [&](const auto& row) { return row[0] == name; });
  return found == table.rows.end() ? nullptr : &*found;
}

// Everything that stands before the appendix.
std::vector<std::string> bodyTexts(const ReportContent& content) {
  auto texts = content.sentences;
  auto tables = content.body;
  tables.push_back(content.squatList);
  for (const auto& page : content.squats) texts.push_back(page.heading), tables.push_back(page.facts);
  for (const auto& table : tables) {
    texts.push_back(table.heading);
    texts.insert(texts.end(), table.columns.begin(), table.columns.end());
    for (const auto& row : table.rows) texts.insert(texts.end(), row.begin(), row.end());
  }
  return texts;
}

// Three lines as triangles over equal steps: the parabola through three samples has its vertex in the middle one.
signals::Features featuresByHand() {
  signals::Features features;
  features.unit = "m/s2", features.speed = 30;
  features.minimum = -100.2, features.maximum = 110.4;
  features.wavelengthByCrossings = 0.0261;
  for (int i = 0; i <= 200; ++i) {
    features.spectrum.frequency.push_back(10 * i);
    features.spectrum.density.push_back(0);
  }
  for (const auto& [line, density] :
       {std::pair{30, 9.0}, std::pair{109, 6.0}, std::pair{55, 3.0}, std::pair{150, 1.0}}) {
    auto& all = features.spectrum.density;
    const auto at = static_cast<std::size_t>(line);
    all[at] = density, all[at - 1] = all[at + 1] = density / 2;
  }
  return features;
}

TEST(ReportSentence, saysARunInPlainWords) {
  const auto run = runOf(caseWith({}));
  EXPECT_EQ(signalSentence({"light-defect", "", run, run}, {featuresByHand(), {}}),
            "Light defect, 30 m/s, mesh draft: axle box acceleration from -100 to 110 m/s²; strongest lines at 300, "
            "1090 and 550 Hz; wavelength behind the defect 26.1 mm.");
  auto features = featuresByHand();
  features.wavelengthByCrossings = NAN, features.spectrum = {};
  run->complete = false;
  EXPECT_EQ(signalSentence({"deep", "", run, run}, {features, {}}),
            "deep (Light defect), 30 m/s, mesh draft, stopped before its end: axle box acceleration from -100 to 110 "
            "m/s².");
}

TEST(ReportSentence, saysWhatIsMeasuredAndWhatCannotBeAnalysed) {
  auto record = std::make_shared<signals::Record>();
  record->speed = 27.78;
  EXPECT_EQ(signalSentence({"first bogie", "ride.csv", record}, {}),
            "first bogie, measured, 27.8 m/s: no axle box acceleration that can be analysed.");
}

TEST(ReportSentence, countsTheEvents) {
  EXPECT_EQ(eventSentence({}), "");
  EXPECT_EQ(eventSentence(ride()), "Long records: 2 squats (1 moderate, 1 severe) and 1 other event.");
  Report quiet;
  quiet.events.records = {"ride.csv"};
  EXPECT_EQ(eventSentence(quiet), "Long records: no squats and no other events.");
}

// Titles of the catalogue, in the units of people who walk along the track.
TEST(ReportSummary, hasTitlesInWords) {
  const auto content = contentOf(twoRuns());
  ASSERT_EQ(content.body.size(), 2U);
  const auto& summary = content.body[0];
  EXPECT_EQ(summary.heading, "Summary");
  EXPECT_THAT(summary.columns, ElementsAre("quantity", "shallow", "deep"));
  const auto* depth = rowNamed(summary, "Depth [mm]");
  ASSERT_TRUE(depth);
  EXPECT_THAT(*depth, ElementsAre("Depth [mm]", "0.2", "0.4"));
  const auto* line = rowNamed(summary, "Line 1 of the spectrum [Hz]");
  ASSERT_TRUE(line);
  // The largest value near 300 Hz of the closed form's transform under a Hann window from 100 mm before to 280 mm
  // behind lies at 291.9 Hz (computed once, without this code): the decay and the line at 1 kHz move it. Between
  // samples of the spectrum it is found by a parabola.
  EXPECT_NEAR(std::stod((*line)[1]), 291.9, 1);
  const auto* ratio = rowNamed(summary, "Largest acceleration by that of shallow");
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(std::stod((*ratio)[2]), 2, 0.02);  // made twice as high, the hum of 0.1 m/s2 alone is not
  EXPECT_TRUE(rowNamed(summary, analysis::featureTitle("peak [m/s2]") + " [m/s²]"));
  EXPECT_TRUE(rowNamed(summary, "Power, 200-400 Hz [(m/s²)²]"));
  EXPECT_TRUE(rowNamed(summary, "Wavelength behind the defect, by zero crossings [mm]"));
  const auto* force = rowNamed(summary, "Largest contact force [kN]");
  ASSERT_TRUE(force);
  EXPECT_GT(std::stod((*force)[2]), 90);
  EXPECT_LT(std::stod((*force)[2]), 160);  // 90 kN and 500 N for each of at most 120 m/s2
}

TEST(ReportSummary, hasNoRowOfNothing) {
  auto report = twoRuns();
  report.signals.resize(1);  // nothing to compare with
  const auto content = contentOf(report);
  EXPECT_FALSE(rowNamed(content.body[0], "Correlation with shallow"));
  EXPECT_FALSE(rowNamed(content.body[0], "Depth [mm]"));
  for (const auto& tables : {content.body, content.appendix, contentOf(twoRuns()).body, contentOf(twoRuns()).appendix})
    for (const auto& table : tables)
      for (const auto& row : table.rows) {
        EXPECT_TRUE(std::any_of(row.begin() + 1, row.end(), [](const auto& cell) { return cell != "-"; }))
            << table.heading << ": " << row[0];
        // Unit and meaning stand beside a value that is missing, too.
        if (table.columns[0] == "feature" || table.columns[0] == "key") EXPECT_NE(row[1], "-") << row[0];
      }
}

TEST(ReportSummary, hasFourSignalsInATable) {
  auto report = twoRuns();
  for (const char* name : {"third", "fourth", "fifth"}) {
    report.signals.push_back(report.signals[1]);
    report.signals.back().name = name;
  }
  const auto content = contentOf(report);
  ASSERT_EQ(content.body.size(), 3U);
  EXPECT_THAT(content.body[0].columns, ElementsAre("quantity", "shallow", "deep", "third", "fourth"));
  EXPECT_EQ(content.body[1].heading, "Summary, continued");
  EXPECT_THAT(content.body[1].columns, ElementsAre("quantity", "fifth"));
}

// The depth differs between the runs and is in the summary; every other key is at its default.
TEST(ReportInputs, areThoseThatAreNoDefaults) {
  const auto inputs = changedInputs(twoRuns());
  ASSERT_EQ(inputs.rows.size(), 1U);
  EXPECT_THAT(inputs.rows[0], ElementsAre("Pad stiffness [MN/m]", "2000", "1300"));
  auto report = twoRuns();
  const auto usual = runOf(caseWith({}));
  report.signals = {{"usual", "", usual, usual}};
  EXPECT_THAT(changedInputs(report).rows, IsEmpty());
  EXPECT_THAT(changedInputs(ride()).rows, IsEmpty());
}

TEST(ReportContent, hasNoKeyBeforeTheAppendix) {
  const std::regex snakeCase("[a-z0-9]+_[a-z0-9]");
  auto both = twoRuns();
  both.events = ride().events;
  for (const auto& text : bodyTexts(contentOf(both))) EXPECT_FALSE(std::regex_search(text, snakeCase)) << text;
}

TEST(ReportContent, hasFilesFeaturesAndEveryKeyInTheAppendix) {
  auto both = twoRuns();
  both.events = ride().events;
  const auto content = contentOf(both);
  std::vector<std::string> headings;
  for (const auto& table : content.appendix) headings.push_back(table.heading);
  EXPECT_THAT(headings, ElementsAre("Runs", "Other events", "Features of shallow", "Case of shallow"));
  EXPECT_TRUE(rowNamed(content.appendix[3], "rail.young_modulus"));
  EXPECT_TRUE(rowNamed(content.appendix[2], "Line 1 of the spectrum"));
  for (const auto& row : content.appendix[2].rows) {
    EXPECT_THAT(row[0], Not(HasSubstr("_")));
    EXPECT_THAT(row[3], Not(HasSubstr("_")));
  }
  ASSERT_EQ(content.appendix[1].rows.size(), 1U);  // columns in which nothing stands are left out
  EXPECT_THAT(content.appendix[1].columns,
              ElementsAre("place [m]", "kind", "sure", "largest acceleration [m/s²]", "decided by"));
  EXPECT_THAT(content.appendix[1].rows[0], ElementsAre("200.00", "joint", "91 %", "100", "as labelled"));
}

TEST(ReportSquats, haveAPageEach) {
  auto report = ride();
  report.events.events[0].side = "right", report.events.events[0].sideSureness = 0.7;
  report.seen = {{12345.6, "left", "severe squat"}};
  const auto content = contentOf(report);
  ASSERT_EQ(content.squats.size(), 2U);
  EXPECT_EQ(content.squats[0].heading, "Squat at 12345.68 m");
  EXPECT_EQ(content.squats[0].event, 0U);
  EXPECT_EQ(content.squats[1].heading, "Squat at 400.00 m");
  EXPECT_EQ(content.squats[1].event, 2U);
  EXPECT_THAT(
      content.squats[0].facts.rows,
      ElementsAre(Row{"Kind", "squat, 91 % sure"}, Row{"Place", "12345.68 m"}, Row{"Rail", "right, 70 % sure"},
                  Row{"Severity", "moderate (light 10 %, moderate 70 %, severe 20 %)"},
                  Row{"Length, with its 90 % range", "45 mm (30 to 60 mm)"},
                  Row{"Depth, with its 90 % range", "0.20 mm (0.10 to 0.30 mm)"},
                  Row{"Largest acceleration", "100 m/s²"}, Row{"Speed", "30 m/s"}, Row{"Passages", "found in 2 of 3"},
                  Row{"Label", "severe squat"}, Row{"Record", "day 1.csv, channel left"}));
  EXPECT_FALSE(rowNamed(content.squats[1].facts, "Rail"));
  EXPECT_FALSE(rowNamed(content.squats[1].facts, "Label"));
  ASSERT_EQ(content.squatList.rows.size(), 2U);
  EXPECT_THAT(content.squatList.rows[0], ElementsAre("12345.68", "right", "moderate", "91 %", "45 mm (30 to 60 mm)",
                                                     "0.20 mm (0.10 to 0.30 mm)", "100", "severe squat"));
}

// A list of an older version has no probabilities.
TEST(ReportSquats, sayTheSeverityAlone) {
  auto report = ride();
  report.events.events[0].severities = {};
  EXPECT_THAT(squatPages(report)[0].facts.rows, Contains(Row{"Severity", "moderate"}));
}

TEST(ReportSquats, haveNoMorePagesThanAnybodyReads) {
  Report report;
  report.events.records = {"/rides/day 1.csv"};
  for (std::size_t i = 0; i < squatsWithPages + 1; ++i) {
    report.events.events.push_back(squatAt(10.0 * static_cast<double>(i), "light"));
    report.events.events.back().peak = i == 7 ? 20 : 100;
  }
  const auto content = contentOf(report);
  ASSERT_EQ(content.squats.size(), squatsWithPages);
  EXPECT_EQ(content.squats[6].event, 6U);
  EXPECT_EQ(content.squats[7].event, 8U);  // the quietest is in the list alone
  EXPECT_EQ(content.squatList.rows.size(), squatsWithPages + 1);
  EXPECT_THAT(content.squatList.heading, HasSubstr("200 loudest"));
}

TEST(ReportEvents, comeFromTheListOfTheProject) {
  const tests::Folder folder;
  Project project;
  project.records.events = folder.path("squats.json");
  std::vector<std::string> problems;
  EXPECT_THAT(reportOf(project, problems).events.events, IsEmpty());
  EXPECT_THAT(problems, ElementsAre(HasSubstr("squats.json")));
  folder.write("squats.json", R"({"schema": "squat-detection", "schema_version": 1, "records": [{"path": "ride.csv"}],
    "events": [{"position_m": 12.5, "time_s": 1, "record": "ride.csv", "channel": "left", "kind": "weld",
                "sureness": 0.8, "peak_m_s2": 60, "speed_m_s": 30, "passes": 1, "passes_there": 1}]})");
  problems.clear();
  project.records.seen = {{12.5, "left", "weld"}};
  const auto report = reportOf(project, problems);
  EXPECT_THAT(problems, IsEmpty());
  ASSERT_EQ(report.events.events.size(), 1U);
  EXPECT_EQ(report.events.events[0].position, 12.5);
  EXPECT_EQ(report.seen.size(), 1U);
  EXPECT_TRUE(std::filesystem::equivalent(report.eventFolder, folder.path())) << report.eventFolder;
}

}  // namespace
}  // namespace squat::project
