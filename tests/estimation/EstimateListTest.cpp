// Estimates of many passages, one by one and as a table.
#include "estimation/EstimateList.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "estimation/EstimateFiles.h"
#include "results/SampleResult.h"

namespace squat::estimation {
namespace {

using squat::tests::TemporaryFolder;

const EstimateRow kDone{"in/a.csv", false, "a note", {1e-4, 0.5e-4, 2e-4}, {0.03, 0.02, 0.04}, 1.25, 80.04, 60};
const EstimateRow kFailed{"in/b.csv", true, "no event, nowhere", {}, {}, 0, 0, 0};

TEST(EstimateList, ARowComesBackUnderItsKeyAlone) {
  const TemporaryFolder folder;
  EXPECT_FALSE(readRow(folder.path(), "in/a.csv", "key"));
  writeRow(folder.path(), kDone, "key", nullptr);
  writeRow(folder.path(), kFailed, "key", nullptr);
  const auto row = readRow(folder.path(), "in/a.csv", "key");
  ASSERT_TRUE(row);
  EXPECT_EQ(row->depth.high, 2e-4);
  EXPECT_EQ(row->length.value, 0.03);
  EXPECT_EQ(row->misfit, 1.25);
  EXPECT_EQ(row->peak, 80.04);
  EXPECT_EQ(row->runs, 60);
  EXPECT_EQ(row->message, "a note");
  EXPECT_TRUE(readRow(folder.path(), "in/b.csv", "key")->hasFailed);
  EXPECT_FALSE(readRow(folder.path(), "in/a.csv", "other"));
  writeDurably(folder / "a/estimate.json", std::string_view("{}"));
  EXPECT_THROW(readRow(folder.path(), "in/a.csv", "key"), FileError);
}

// Stopped between the estimate and its row, or estimated without --each: it is computed again, which is no error.
TEST(EstimateList, AnEstimateWithoutARowIsNotKnown) {
  const TemporaryFolder folder;
  makeFolder(folder / "a");
  Estimate estimate;
  writeDurably(folder / "a/estimate.json", std::string_view(estimateJson(estimate)));
  EXPECT_FALSE(readRow(folder.path(), "in/a.csv", "key"));
}

TEST(EstimateList, NamesAndMessagesNeedNotBeUtf8) {
  const TemporaryFolder folder;
  auto row = kFailed;
  row.message =
      "gleis-s\xfc"
      "d.csv has no event";
  writeRow(folder.path(), row, "key", nullptr);
  EXPECT_THAT(readRow(folder.path(), "in/b.csv", "key")->message, ::testing::HasSubstr("has no event"));
}

TEST(EstimateList, TheTableHasTheColumnsThatOthersRead) {
  EXPECT_EQ(estimatesText({kDone, kFailed}),
            "passage,state,depth [um],depth low [um],depth high [um],length [mm],length low [mm],length high [mm],"
            "misfit,peak [m/s2],runs,message\n"
            "in/a.csv,done,100.0,50.0,200.0,30.0,20.0,40.0,1.25,80.0,60,a note\n"
            "in/b.csv,failed,,,,,,,,,,\"no event, nowhere\"\n");
}

// Case, options and content decide; the name of the file does not.
TEST(EstimateList, TheKeyFollowsWhatDecides) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return folder / name;
  };
  EstimateDefinition definition;
  definition.caseName = "light-defect";
  definition.files = {write("a.csv", "time [s],aba [m/s2]\n0,1\n")};
  const auto key = estimateKey(definition, {});
  auto other = definition;
  other.files = {write("b.csv", "time [s],aba [m/s2]\n0,1\n")};
  EXPECT_EQ(estimateKey(other, {}), key);
  other.files = {write("c.csv", "time [s],aba [m/s2]\n0,2\n")};
  EXPECT_NE(estimateKey(other, {}), key);
  other = definition;
  other.cutoff = 1500;
  EXPECT_NE(estimateKey(other, {}), key);
  other = definition;
  other.overrides.values.push_back({"motion.speed", "20"});
  EXPECT_NE(estimateKey(other, {}), key);
}

}  // namespace
}  // namespace squat::estimation
