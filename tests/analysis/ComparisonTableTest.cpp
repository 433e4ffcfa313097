// The table of runs and measured signals: its numbers are those that squat analyse and squat compare print.
#include "analysis/ComparisonTable.h"

#include <gmock/gmock.h>

#include <map>

#include "analysis/AnalysisFiles.h"
#include "analysis/FileComparison.h"
#include "analysis/Folder.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "core/Errors.h"
#include "text/Csv.h"

namespace squat::analysis {
namespace {

using tests::Folder;
using tests::runTable;

signals::Record only(const std::string& path) {
  auto records = readers::readSignals(path);
  EXPECT_EQ(records.size(), 1U);
  return records.at(0);
}

// Those that there are: not-a-number equals nothing.
std::map<std::string, double> byName(const NamedNumbers& numbers) {
  std::map<std::string, double> found;
  for (const auto& [name, value] : numbers)
    if (!std::isnan(value)) found[name] = value;
  return found;
}

cases::ComparedCase caseWith(const char* key, const char* value) {
  cases::CaseDescription description = cases::defaultCase();
  cases::setValue(description, key, value);
  return cases::comparedCase(description);
}

// The same files through the commands' own path. Same arithmetic: the same bits.
TEST(ComparisonTable, numbersAreThoseOfTheCommands) {
  const Folder folder;
  const auto computed = folder.write("computed.csv", runTable(0.08, 60, 30));
  const auto measured = folder.write("measured.csv", runTable(0.1, 40, 29, 1000));
  Monitor monitor;
  const auto features = featureTable(analyse({computed}, {}, monitor));
  std::map<std::string, double> analysed;
  for (std::size_t i = 0; i < features.names.size(); ++i) analysed[features.names[i]] = features.values[0][i];
  const auto shown = byName(signalNumbers(only(computed)));
  EXPECT_GE(shown.size(), 7U);  // peak, two lines of three, wavelength, three bands
  EXPECT_EQ(shown.at("peak [m/s2]"), analysed.at("peak [m/s2]"));
  EXPECT_EQ(shown.at("line 1 [Hz]"), analysed.at("peak 1 frequency [Hz]"));
  EXPECT_EQ(shown.at("line 2 [Hz]"), analysed.at("peak 2 frequency [Hz]"));
  EXPECT_EQ(shown.at("wavelength by crossings [m]"), analysed.at("wavelength by crossings [m]"));
  EXPECT_EQ(shown.at("power 200-400 Hz [(m/s2)2]"), analysed.at("power 200-400 Hz [(m/s2)2]"));
  // runTable rings at 300 and 1034 Hz; a line is found to half the spectrum's step of 3 Hz and the width of its slope.
  EXPECT_NEAR(std::min(shown.at("line 1 [Hz]"), shown.at("line 2 [Hz]")), 300, 10);

  const auto pair = compareFiles(computed, {measured}, {}, monitor).at(0).comparison;
  const auto beside = byName(likenessNumbers(only(computed), only(measured)));
  EXPECT_EQ(beside.at("correlation [-]"), pair.correlation);
  EXPECT_EQ(beside.at("peak ratio [-]"), pair.peakRatio);
  const auto itself = byName(likenessNumbers(only(computed), only(computed)));
  EXPECT_NEAR(itself.at("correlation [-]"), 1, 1e-6);  // the shift is found to a fortieth of a sample
  EXPECT_NEAR(itself.at("peak ratio [-]"), 1, 1e-3);
}

// A run in memory holds more than its file of one signal: what is taken is the same.
TEST(ComparisonTable, aRunOfSeveralSignalsIsComparedByItsAxleBox) {
  const Folder folder;
  const auto record = only(folder.write("run.csv", runTable(0.08, 60, 30)));
  auto run = record;
  run.signals.insert(run.signals.begin(), {"contact_force", "N", "", std::vector<double>(run.time.size(), 1.0)});
  EXPECT_EQ(byName(signalNumbers(run)), byName(signalNumbers(record)));
  run.position.clear();
  run.signals.erase(run.signals.begin());
  EXPECT_THROW(signalNumbers(run), CaseError);  // no speed is known
}

TEST(ComparisonTable, hasAColumnForWhatDiffersAndADashForWhatIsMissing) {
  const auto shallow = caseWith("defect.depth", "0.15"), deep = caseWith("defect.depth", "0.3");
  const ComparedSignal one{"shallow", &shallow, {{"peak [m/s2]", 101.234567}, {"line 1 [Hz]", 300.04}}, {}};
  const ComparedSignal other{"deep, \"new\"", &deep, {{"peak [m/s2]", 2000}, {"line 1 [Hz]", NAN}}, {}};
  const ComparedSignal measured{"measured\tat km 3", nullptr, {}, {{"correlation [-]", 1}}};
  const auto table = comparisonTable({one, other, measured});
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"signal", "depth [mm]", "peak [m/s2]", "line 1 [Hz]", "correlation [-]"}));
  const auto texts = [&](std::size_t row) {
    std::vector<std::string> cells;
    for (const auto& cell : table.rows.at(row)) cells.push_back(cell.text);
    return cells;
  };
  EXPECT_EQ(texts(0), (std::vector<std::string>{"shallow", "0.15", "101.2", "300", "-"}));
  EXPECT_EQ(texts(1), (std::vector<std::string>{"deep, \"new\"", "0.3", "2000", "-", "-"}));
  EXPECT_EQ(texts(2), (std::vector<std::string>{"measured\tat km 3", "-", "-", "-", "1"}));
  EXPECT_EQ(table.rows[0][1].number, 0.15);  // sorts as a number

  const auto records = text::csvRecords(tableCsv(table));
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[1], (std::vector<std::string>{"shallow", "0.15", "101.234567", "300.04", ""}));
  EXPECT_EQ(records[2], (std::vector<std::string>{"deep, \"new\"", "0.3", "2000", "", ""}));
  const std::string tabbed = tabbedText(table);
  EXPECT_EQ(tabbed.substr(0, tabbed.find('\n')), "signal\tdepth [mm]\tpeak [m/s²]\tline 1 [Hz]\tcorrelation [-]");
  EXPECT_THAT(tabbed, testing::HasSubstr("\nshallow\t0.15\t101.2\t300\t-\n"));
  EXPECT_THAT(tabbed, testing::EndsWith("\nmeasured at km 3\t-\t-\t-\t1\n"));
}

// A run whose right side is as its left one has no value of its own there.
TEST(ComparisonTable, hasAColumnForWhatTheRightSideHasOfItsOwn) {
  cases::CaseDescription description = cases::defaultCase();
  cases::setValue(description, "model.extent", "whole");
  const auto alike = cases::comparedCase(description);
  ASSERT_EQ(cases::trySetRight(description, "defect.depth", "0.3"), std::nullopt);
  const auto deeper = cases::comparedCase(description);
  const auto table = comparisonTable({{"alike", &alike, {}, {}}, {"deeper", &deeper, {}, {}}});
  EXPECT_EQ(table.columns, (std::vector<std::string>{"signal", "right depth [mm]"}));
  EXPECT_EQ(table.rows[0][1].text, "-");
  EXPECT_EQ(table.rows[1][1].text, "0.3");
}

TEST(ComparisonTable, ofNothingHasOnlyItsHeading) { EXPECT_EQ(tableCsv(comparisonTable({})), "signal\n"); }

}  // namespace
}  // namespace squat::analysis
