#include "calibration/EvaluationTable.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::calibration {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

CalibrationDefinition definition() {
  CalibrationDefinition made;
  made.caseName = "light-defect", made.caseHash = "0123abcd";
  made.inputs = freeInputsFromText({"defect.depth=0.05:0.3"});
  statements::Statement peak;
  peak.name = "peak", peak.measure = "maximum", peak.low = 80, peak.high = 120, peak.unit = "m/s2";
  made.targets.statements.push_back({peak, 1});
  return made;
}

Evaluation row(double depth, double peak) {
  Evaluation evaluation;
  evaluation.stage = Stage::global, evaluation.mesh = "tiny", evaluation.values = {depth};
  evaluation.misfit = 0.1 * peak;
  TargetValue value;
  value.value = peak, value.isMet = true, value.misfit = 0.1 * peak, value.residuals = {1.0 / 3.0};
  evaluation.targets = {value};
  return evaluation;
}

TEST(EvaluationTable, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const auto made = definition();
  EvaluationTable first(made, folder.path());
  first.add(row(0.1, 87.5));
  auto failed = row(0.2, 0);
  failed.hasFailed = true, failed.message = "a reason, with a comma", failed.targets.clear();
  first.add(failed);
  const EvaluationTable second(made, folder.path());
  ASSERT_EQ(second.rows().size(), 2u);
  const auto* known = second.find("tiny", {0.1});
  ASSERT_TRUE(known);
  EXPECT_EQ(known->misfit, 8.75);
  EXPECT_EQ(known->targets[0].residuals, std::vector<double>{1.0 / 3.0});  // to the bit
  EXPECT_EQ(known->stage, Stage::global);
  EXPECT_TRUE(second.find("tiny", {0.2})->hasFailed);
  EXPECT_EQ(second.find("tiny", {0.2})->message, "a reason, with a comma");
  EXPECT_FALSE(second.find("draft", {0.1}));
}

TEST(EvaluationTable, AnotherCalibrationIsRefused) {
  const TemporaryFolder folder;
  const auto made = definition();
  EvaluationTable(made, folder.path()).add(row(0.1, 87.5));
  auto otherLimits = made;
  otherLimits.inputs[0].high = 0.4;
  EXPECT_THROW(EvaluationTable(otherLimits, folder.path()), CaseError);
  auto otherRange = made;
  otherRange.targets.statements[0].statement.high = 130;
  EXPECT_THROW(EvaluationTable(otherRange, folder.path()), CaseError);
  std::ofstream(folder / "a.csv") << "time [s],aba [m/s2]\n0,1\n";
  auto withSignal = made;
  withSignal.targets.signals.push_back({});
  withSignal.targets.signals[0].files = {folder / "a.csv"};
  const TemporaryFolder other;
  EXPECT_NO_THROW(const EvaluationTable begun(withSignal, other.path()));
  withSignal.targets.signals[0].noise = 0.02;
  EXPECT_THROW(EvaluationTable(withSignal, other.path()), CaseError);
}

// A laboratory's own calibration.csv is nobody else's to replace.
TEST(EvaluationTable, AForeignFileOfItsNameIsKept) {
  const TemporaryFolder folder;
  std::ofstream(folder / "calibration.csv") << "sensor,sensitivity\nA,1.02\n";
  EXPECT_THROW(EvaluationTable(definition(), folder.path()), CaseError);
  EXPECT_THAT(readWholeFile(folder / "calibration.csv", 100), HasSubstr("sensor"));
}

// What a part has computed is known, and becomes a row once the search comes to it.
TEST(EvaluationTable, TakesWhatPartsHaveComputed) {
  const TemporaryFolder folder;
  const auto made = definition();
  EvaluationTable(made, partFolder(folder.path(), {studies::Partition::Kind::slice, 1, 2})).add(row(0.1, 87.5));
  EvaluationTable(made, partFolder(folder.path(), {studies::Partition::Kind::slice, 2, 2})).add(row(0.2, 99));
  EvaluationTable whole(made, folder.path());
  EXPECT_FALSE(whole.find("tiny", {0.1}));
  whole.takeParts();
  EXPECT_TRUE(whole.rows().empty());
  ASSERT_TRUE(whole.find("tiny", {0.2}));
  EXPECT_EQ(whole.find("tiny", {0.2})->targets[0].value, 99);
  whole.add(*whole.find("tiny", {0.2}));
  whole.add(*whole.find("tiny", {0.2}));
  ASSERT_EQ(whole.rows().size(), 1u);
  EXPECT_EQ(EvaluationTable(made, folder.path()).rows().size(), 1u) << "and is in the file";
}

TEST(EvaluationTable, PartsOfAnotherCalibrationAreRefused) {
  const TemporaryFolder folder;
  const auto made = definition();
  auto other = made;
  other.inputs[0].high = 0.4;
  EvaluationTable(other, partFolder(folder.path(), {studies::Partition::Kind::slice, 1, 2})).add(row(0.1, 87.5));
  EvaluationTable whole(made, folder.path());
  EXPECT_THROW(whole.takeParts(), CaseError);
}

TEST(EvaluationTable, DamageIsFound) {
  const auto made = definition();
  for (const char* name : {"calibration.csv", "calibration-residuals.csv", "calibration.json"}) {
    const TemporaryFolder folder;
    EvaluationTable(made, folder.path()).add(row(0.1, 87.5));
    std::ofstream(folder / name) << "stage,mesh\nx\n";
    EXPECT_THROW(EvaluationTable(made, folder.path()), FileError) << name;
  }
}

}  // namespace
}  // namespace squat::calibration
