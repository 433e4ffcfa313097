// Warm states on disk: every bit comes back, and what is damaged, foreign or old is refused.
#include "simulation/WarmStateFile.h"

#include <gmock/gmock.h>

#include <limits>
#include <span>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "results/TreeStream.h"
#include "simulation/StoppedRuns.h"

namespace squat::simulation {
namespace {

using squat::tests::comparable;
using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

constexpr std::size_t kLargest = 100'000'000;  // [bytes]

cases::CaseDescription shortCase() {
  return cases::loadCase(tests::fixtureCase("light-defect"),
                         {"tiny", {{"motion.run_up", "0.06"}, {"motion.beyond", "0.03"}}});
}

RunOptions oneThread() {
  RunOptions options;
  options.threads = 1;
  return options;
}

const WarmState& sample() {
  static const WarmState warm = [] {
    Monitor silent;
    return makeWarmState(shortCase(), oneThread(), silent).value();
  }();
  return warm;
}

// How reading, or else a run from what was read, refuses; "accepted".
std::string refusal(const std::string& path) {
  try {
    auto options = oneThread();
    options.warm = std::make_shared<const WarmState>(readWarmState(path));
    Monitor silent;
    runCase(shortCase(), options, silent);
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

// The sample as a file in which `change` was made.
template <typename Change>
std::string refusalOf(const Change& change) {
  const TemporaryFolder folder;
  const auto path = folder / "s.warm";
  writeWarmState(path, sample());
  const auto bytes = readWholeFile(path, kLargest);
  auto tree = results::decodeTree(results::sourceOf(std::as_bytes(std::span(bytes))), path, kLargest);
  change(tree);
  writeDurably(path, results::encodeTree(tree));
  return refusal(path);
}

std::vector<double>& valuesIn(results::ArrayTree& tree, const char* path) {
  return std::get<std::vector<double>>(tree.find(path)->values);
}

void dropLast(results::ArrayTree& tree, const char* path) {
  valuesIn(tree, path).pop_back();
  tree.find(path)->shape = {valuesIn(tree, path).size()};
}

TEST(WarmStateFile, GivesBackEveryBit) {
  const TemporaryFolder folder;
  writeWarmState(folder / "s.warm", sample());
  const auto back = readWarmState(folder / "s.warm");
  EXPECT_EQ(cases::caseHash(back.description), cases::caseHash(sample().description));
  EXPECT_EQ(back.position, sample().position);
  EXPECT_EQ(back.state.arrays.size(), sample().state.arrays.size());
  for (const auto& array : sample().state.arrays) {
    ASSERT_NE(back.state.find(array.path), nullptr) << array.path;
    EXPECT_EQ(*back.state.find(array.path), array) << array.path;
  }
  auto options = oneThread();
  Monitor silent;
  const auto whole = runCase(shortCase(), options, silent);
  options.warm = std::make_shared<const WarmState>(back);
  EXPECT_EQ(results::firstDifference(comparable(whole), comparable(runCase(shortCase(), options, silent))), "");
}

TEST(WarmStateFile, DamageIsFound) {
  const TemporaryFolder folder;
  writeWarmState(folder / "good.warm", sample());
  const auto good = readWholeFile(folder / "good.warm", kLargest);
  const std::size_t step = good.size() / 40;
  for (std::size_t i = 3; i < good.size(); i += step) {
    auto bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    writeDurably(folder / "bad.warm", std::string_view(bad));
    EXPECT_THROW(readWarmState(folder / "bad.warm"), FileError) << "byte " << i;
    writeDurably(folder / "bad.warm", std::string_view(good.substr(0, i)));
    EXPECT_THROW(readWarmState(folder / "bad.warm"), FileError) << "length " << i;
  }
  EXPECT_THROW(readWarmState(folder / "none.warm"), FileError);
}

TEST(WarmStateFile, ForeignAndOldOnesAreRefusedByName) {
  const TemporaryFolder folder;
  results::writeCheckpoint(folder / "c", sample().state);
  EXPECT_THAT(refusal(folder / "c"), HasSubstr("is not a warm state"));
  writeWarmState(folder / "w", sample());
  EXPECT_THROW(results::readCheckpoint(folder / "w"), FileError);
  EXPECT_THAT(refusalOf([](auto& tree) { setAttribute(tree.attributes, "schema_version", std::int64_t{99}); }),
              HasSubstr("newer version"));
  EXPECT_THAT(refusalOf([](auto& tree) { setAttribute(tree.attributes, "code_version", std::string("0.0.1")); }),
              HasSubstr("version 0.0.1 of the program"));
  EXPECT_THAT(refusalOf([](auto& tree) { setAttribute(tree.attributes, "state_layout", std::int64_t{5}); }),
              HasSubstr("another version"));
  EXPECT_THAT(refusalOf([](auto& tree) { setAttribute(tree.attributes, "shared_hash", std::string("00000000")); }),
              HasSubstr("does not match the stored hash"));
  EXPECT_THAT(refusalOf([](auto& tree) { setAttribute(tree.attributes, "case_toml", std::string("[track]\nx = ")); }),
              HasSubstr("no case that this version can read"));
}

// A file may be anybody's: what does not fit the model is refused before it is taken, with what to do.
TEST(WarmStateFile, ArraysThatDoNotFitAreRefused) {
  const auto advice = HasSubstr("Make it again with squat warm");
  EXPECT_THAT(refusalOf([](auto& tree) { dropLast(tree, "/rolling/velocity"); }),
              AllOf(HasSubstr("/rolling/velocity"), HasSubstr("squat warm")));
  EXPECT_THAT(refusalOf([](auto& tree) { valuesIn(tree, "/rolling/scalars")[0] = 1e12; }), HasSubstr("beyond the end"));
  EXPECT_THAT(refusalOf([](auto& tree) { dropLast(tree, "/recorder/pending"); }), HasSubstr("/recorder"));
  EXPECT_THAT(refusalOf([](auto& tree) { dropLast(tree, "/energy_balance"); }), HasSubstr("/energy_balance"));
  EXPECT_THAT(
      refusalOf([](auto& tree) { valuesIn(tree, "/rolling/displaced")[7] = std::numeric_limits<double>::infinity(); }),
      AllOf(HasSubstr("/rolling/displaced"), advice));
}

TEST(WarmStateFile, AStateOfAnotherProcessorIsReported) {
  auto foreign = sample();
  setAttribute(foreign.state.attributes, "isa", std::string("abacus"));
  auto options = oneThread();
  options.warm = std::make_shared<const WarmState>(foreign);
  Monitor silent;
  const auto result = runCase(shortCase(), options, silent);
  EXPECT_THAT(result.warnings, ::testing::Contains(HasSubstr("from a warm state of abacus")));
}

}  // namespace
}  // namespace squat::simulation
