// Files of every released schema version, frozen in the tree (made by tests/fuzz/MakeCorpus.cpp when the version was
// current): each must go on being read, with the same numbers.
#include <gtest/gtest.h>

#include "core/DurableFile.h"
#include "results/Checkpoint.h"
#include "results/Hdf5.h"
#include "results/ResultFile.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"

namespace squat::results {
namespace {

TEST(Compatibility, ResultOfSchema1) {
  const auto result = readResult(SQUAT_SOURCE_DIR "/tests/results/frozen/squat-result-1.h5");
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.stem, "sample");
  EXPECT_EQ(result.codeVersion, "0.1.0");
  EXPECT_EQ(result.commit, "");  // not stored before 0.2.0
  EXPECT_EQ(result.caseHash, "0123abcd");
  EXPECT_EQ(result.caseToml, "schema = 1\n");
  EXPECT_EQ(result.threads, 2);
  ASSERT_EQ(result.time.size(), 5U);
  EXPECT_EQ(result.time[4], 4 / 25000.0);
  ASSERT_EQ(result.signals.size(), 3U);
  EXPECT_EQ(result.signals[1].name, "aba");
  EXPECT_EQ(result.signals[1].unit, "m/s2");
  EXPECT_EQ(result.scalogramPower.size(), 6U);
  EXPECT_EQ(result.energy.at(0).values.at(1), 2);
  EXPECT_EQ(result.equilibrium.at(0).value, 87759.5);
  EXPECT_EQ(result.modes.at(1).frequency, 500);
  EXPECT_EQ(result.surface.partNames.at(1), "sleepers");
  EXPECT_EQ(result.snapshots.at(1).plasticStrain.at(2), 1.F);
  EXPECT_EQ(result.patches.at(0).slipping.at(1), 1);
  EXPECT_EQ(result.warnings.at(1), "second warning");
}

// 0.2.0 names the commit, and holds no features.
TEST(Compatibility, ResultOf020) {
  const auto result = readResult(SQUAT_SOURCE_DIR "/tests/results/frozen/squat-result-1-of-0.2.0.h5");
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.codeVersion, "0.2.0");
  EXPECT_EQ(result.commit, "0123456789ab");
  EXPECT_TRUE(result.features.empty());
  EXPECT_EQ(result.time.at(4), 4 / 25000.0);
  EXPECT_EQ(result.signals.at(1).name, "aba");
  EXPECT_EQ(result.plasticity.at(0).value, 3e-3);
  EXPECT_EQ(result.permanent.height.at(2), -2e-6);
  EXPECT_EQ(result.modes.at(1).frequency, 500);
}

// As the writer of 0.3.0 wrote it, with its features.
TEST(Compatibility, ResultOf030) {
  const auto result = readResult(SQUAT_SOURCE_DIR "/tests/results/frozen/squat-result-1-of-0.3.0.h5");
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.codeVersion, "0.3.0");
  EXPECT_EQ(result.commit, "d6437c1ea2e0");
  EXPECT_EQ(result.features.at(0).value, 110.25);
  EXPECT_EQ(result.time.at(4), 4 / 25000.0);
  EXPECT_EQ(result.signals.at(1).name, "aba");
  EXPECT_EQ(result.permanent.height.at(2), -2e-6);
  EXPECT_EQ(result.patches.at(0).slipping.at(1), 1);
  EXPECT_EQ(result.modes.at(1).frequency, 500);
}

// Within one schema a newer program may add datasets: the rest is read, and the reader says what it leaves out. A
// signal or a number in a known list is no such thing.
TEST(Compatibility, WhatANewerProgramHasAddedIsNamed) {
  const tests::TemporaryFolder folder;
  auto tree = toTree(tests::sampleResult());
  setAttribute(tree.attributes, "code_version", std::string("0.9.0"));
  tree.add("/wear/depth", std::vector<double>{1, 2}, "m");
  tree.add("/spectra/phase", std::vector<double>{1, 2, 3}, "rad");
  tree.addScalar("/features/loudness", 3, "sone");
  writeDurably(folder / "newer.h5", encodeHdf5(tree, "newer.h5"));
  const auto result = readResult(folder / "newer.h5");
  EXPECT_EQ(result.notRead, "/spectra/phase, /wear/depth, written by version 0.9.0");
  EXPECT_EQ(result.features.back().name, "loudness");
  EXPECT_EQ(result.psd, tests::sampleResult().psd);

  writeResult(folder / "own.h5", tests::sampleResult());
  EXPECT_EQ(readResult(folder / "own.h5").notRead, "");
  for (const char* frozen : {"squat-result-1.h5", "squat-result-1-of-0.2.0.h5", "squat-result-1-of-0.3.0.h5"})
    EXPECT_EQ(readResult(SQUAT_SOURCE_DIR "/tests/results/frozen/" + std::string(frozen)).notRead, "") << frozen;
}

TEST(Compatibility, CheckpointOfSchema1) {
  const auto state = readCheckpoint(SQUAT_SOURCE_DIR "/tests/results/frozen/squat-checkpoint-1");
  ASSERT_TRUE(state.has_value());
  EXPECT_EQ(textAttribute(state->attributes, "isa"), "avx2");
  EXPECT_EQ(std::get<std::vector<double>>(state->find("/displacement")->values).at(1), 0.25);
}

}  // namespace
}  // namespace squat::results
