#include "results/ResultFile.h"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <limits>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Hdf5.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"

namespace squat::results {
namespace {

using ::testing::HasSubstr;
using tests::refusal;
using tests::sampleResult;
using tests::TemporaryFolder;

void writeTree(const std::string& path, const ArrayTree& tree) { writeDurably(path, encodeHdf5(tree, path)); }

TEST(ResultFile, GivesBackEveryBit) {
  const TemporaryFolder folder;
  auto result = sampleResult();
  result.signals[0].values[7] = std::numeric_limits<double>::quiet_NaN();  // a failed run may hold one
  result.signals[0].values[8] = -0.0;
  writeResult(folder / "sample.h5", result);
  const auto back = readResult(folder / "sample.h5");
  EXPECT_EQ(firstDifference(toTree(result), toTree(back)), "");
  EXPECT_EQ(back.signals[0].name, "wheel_speed");  // the order of writing, not of the alphabet
  EXPECT_TRUE(back.complete);
  EXPECT_EQ(back.commit, "0123456789ab-changed");
  EXPECT_EQ(back.caseToml, result.caseToml);
  EXPECT_EQ(back.warnings, result.warnings);
  ASSERT_EQ(back.features.size(), 2U);
  EXPECT_EQ(back.features[0].description, "largest absolute value");
  ASSERT_EQ(back.snapshots.size(), 2U);
  EXPECT_EQ(back.snapshots[1].name, "impact");
}

TEST(ResultFile, WithoutFieldsHasAllTheRest) {
  const TemporaryFolder folder;
  auto result = sampleResult();
  writeResult(folder / "sample.h5", result);
  const auto light = readResult(folder / "sample.h5", ResultContent::withoutFields);
  ASSERT_FALSE(result.surface.quads.empty() || result.snapshots.empty() || result.patches.empty());
  result.surface = {}, result.snapshots.clear(), result.patches.clear();
  EXPECT_EQ(firstDifference(toTree(result), toTree(light)), "");
}

// The right contact has points of its own, here one where the left one has two. A half model has no such datasets.
TEST(ResultFile, KeepsBothContactsOfAWholeModel) {
  const TemporaryFolder folder;
  auto result = sampleResult();
  for (const auto& array : toTree(result).arrays) EXPECT_FALSE(array.path.ends_with("_right")) << array.path;
  auto right = result.patches[0];
  for (auto* values : {&right.x, &right.y, &right.pressure, &right.tractionX, &right.tractionY, &right.area})
    *values = {0.5F};
  right.slipping = {1};
  result.patches[0].right = std::make_shared<const PatchSnapshot>(right);
  writeResult(folder / "whole.h5", result);
  const auto back = readResult(folder / "whole.h5");
  EXPECT_EQ(firstDifference(toTree(result), toTree(back)), "");
  EXPECT_EQ(back.notRead, "");
  ASSERT_TRUE(back.patches.at(0).right);
  EXPECT_EQ(back.patches[0].right->pressure, std::vector<float>{0.5F});
  EXPECT_EQ(back.patches[0].right->name, "equilibrium");
  EXPECT_EQ(back.patches[0].pressure, sampleResult().patches[0].pressure);
  auto tree = toTree(result);
  tree.find("/patch/000/area_right")->values = std::vector<float>{1, 2};
  tree.find("/patch/000/area_right")->shape = {2};
  writeTree(folder / "wrong.h5", tree);
  EXPECT_THAT(refusal(folder / "wrong.h5"), HasSubstr("/patch/000/area_right: has 2 values where 1 belong"));
}

TEST(ResultFile, SurvivesAnEmptyResult) {
  const TemporaryFolder folder;
  writeResult(folder / "empty.h5", RunResult{});
  const auto back = readResult(folder / "empty.h5");
  EXPECT_EQ(firstDifference(toTree(RunResult{}), toTree(back)), "");
  EXPECT_FALSE(isCompleteResult(folder / "empty.h5"));
}

TEST(ResultFile, EveryDatasetHasAUnit) {
  const auto tree = toTree(sampleResult());
  for (const auto& array : tree.arrays) EXPECT_NE(textAttribute(array.attributes, "unit"), "") << array.path;
  EXPECT_GT(tree.arrays.size(), 30U);
}

TEST(ResultFile, EqualResultsGiveEqualBytes) {
  const auto first = encodeHdf5(toTree(sampleResult()), "a.h5");
  const auto second = encodeHdf5(toTree(sampleResult()), "a.h5");
  EXPECT_TRUE(first == second);
}

TEST(ResultFile, RefusesANewerSchemaWithAdvice) {
  const TemporaryFolder folder;
  auto tree = toTree(sampleResult());
  setAttribute(tree.attributes, "schema_version", std::int64_t{kResultVersion + 1});
  writeTree(folder / "newer.h5", tree);
  EXPECT_THAT(refusal(folder / "newer.h5"), HasSubstr("newer"));
  EXPECT_THAT(refusal(folder / "newer.h5"), HasSubstr("Install the newer program"));
}

TEST(ResultFile, RefusesForeignSchemaWrongTypesAndLengths) {
  const TemporaryFolder folder;
  const auto changed = [&](const auto& change) {
    auto tree = toTree(sampleResult());
    change(tree);
    writeTree(folder / "changed.h5", tree);
    return refusal(folder / "changed.h5");
  };
  EXPECT_THAT(changed([](ArrayTree& t) { setAttribute(t.attributes, "schema", std::string("other")); }),
              HasSubstr("/@schema"));
  EXPECT_THAT(changed([](ArrayTree& t) { t.find("/signals/aba")->values = std::vector<std::string>(300, "text"); }),
              HasSubstr("/signals/aba: has a wrong type"));
  EXPECT_THAT(changed([](ArrayTree& t) {
                t.find("/signals/aba")->values = std::vector<double>(299, 1.0);
                t.find("/signals/aba")->shape = {299};
              }),
              HasSubstr("/signals/aba: has 299 values where 300 belong"));
  EXPECT_THAT(changed([](ArrayTree& t) {
                t.find("/mesh/surface/quads")->values = std::vector<std::int32_t>{0, 1, 2, 4};
              }),
              HasSubstr("/mesh/surface/quads: names a point that is not there"));
  EXPECT_THAT(changed([](ArrayTree& t) { t.find("/mesh/surface/part")->values = std::vector<std::uint8_t>{2}; }),
              HasSubstr("/mesh/surface/part"));
}

TEST(ResultFile, MissingAndForeignFilesAreRefusedByName) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "none.h5"), HasSubstr("none.h5"));
  writeDurably(folder / "text.h5", "just text, no HDF5 at all");
  EXPECT_THAT(refusal(folder / "text.h5"), HasSubstr("not an HDF5 file"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("not a regular file"));
  EXPECT_FALSE(isCompleteResult(folder / "none.h5"));
}

TEST(ResultFile, EveryTruncationIsRefused) {
  const TemporaryFolder folder;
  auto result = sampleResult(20);
  result.caseToml.clear();
  const auto image = encodeHdf5(toTree(result), "a.h5");
  for (std::size_t length = 0; length < image.size(); length += image.size() / 12 + 1) {
    writeDurably(folder / "cut.h5", std::span(image).first(length));
    EXPECT_NE(refusal(folder / "cut.h5"), "accepted") << length << " of " << image.size();
  }
}

TEST(ResultFile, AnEarlierResultStaysWhereTheNewOneCannotBeWritten) {
  const TemporaryFolder folder;
  const auto path = folder / "sample.h5";
  writeResult(path, sampleResult());
  auto bad = sampleResult();
  bad.signals.push_back({"aba", "m/s2", "a second one of the same name", bad.time});
  EXPECT_THROW(writeResult(path, bad), FileError);
  EXPECT_TRUE(isCompleteResult(path));
}

// It names files later on.
TEST(ResultFile, AnUntrustedStemLeadsNowhere) {
  const TemporaryFolder folder;
  auto result = sampleResult();
  result.stem = "../../elsewhere/name";
  writeResult(folder / "r.h5", result);
  EXPECT_EQ(readResult(folder / "r.h5").stem, "name");
}

}  // namespace
}  // namespace squat::results
