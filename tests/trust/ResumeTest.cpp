// A run that was stopped and resumed gives the same bits as one that was not: every dataset, also after a change of the
// number of threads. What tells of the machine and the clock (performance, threads, time of writing) is left out.
#include <gmock/gmock.h>

#include <set>

#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "results/TreeStream.h"
#include "simulation/RunCase.h"
#include "simulation/StoppedRuns.h"
#include "trust/ShortCase.h"

namespace squat {
namespace {

using results::ArrayTree;
using results::RunResult;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::CancelAt;
using tests::comparable;
using tests::TemporaryFolder;

cases::CaseDescription shortCase() {
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  overrides.values = tests::shortSets();
  return cases::loadCase(tests::fixtureCase("light-defect"), overrides);
}

RunResult run(const simulation::RunOptions& options, double stopAt = 2) {
  CancelAt monitor(stopAt);
  return simulation::runCase(shortCase(), options, monitor);
}

const RunResult& uninterrupted() {
  static const RunResult result = [] {
    simulation::RunOptions options;
    options.threads = 1;
    return run(options);
  }();
  return result;
}

TEST(Resume, StoppedAndResumedIsTheSameToTheBit) {
  const TemporaryFolder folder;
  simulation::RunOptions options;
  options.threads = 1;
  options.checkpointPath = folder / "run.checkpoint";
  const auto stopped = run(options, 0.3);
  ASSERT_FALSE(stopped.complete);
  ASSERT_TRUE(results::readCheckpoint(options.checkpointPath).has_value());
  EXPECT_LT(stopped.time.size(), uninterrupted().time.size());

  options.resume = true;
  options.threads = 2;  // another number of threads changes nothing
  const auto again = run(options, 0.7);
  ASSERT_FALSE(again.complete);
  const auto resumed = run(options);
  ASSERT_TRUE(resumed.complete);
  EXPECT_EQ(results::firstDifference(comparable(uninterrupted()), comparable(resumed)), "");
}

// Cancels like CancelAt and keeps what it was told.
class Listener : public CancelAt {
 public:
  using CancelAt::CancelAt;
  void report(const Progress& progress) override {
    CancelAt::report(progress);
    phases.insert(progress.phase);
  }
  void message(const std::string& text) override { messages += text + "\n"; }
  std::set<std::string> phases;
  std::string messages;
};

// The first checkpoint is written before the first step. The run is stopped early, its newest checkpoint damaged, the
// one before taken for one of another instruction set: all of it is reported, the equilibrium is not computed again,
// and the numbers are the same.
TEST(Resume, StartsFromTheCheckpointAfterEquilibrium) {
  const TemporaryFolder folder;
  simulation::RunOptions options;
  options.threads = 1;
  options.checkpointPath = folder / "run.checkpoint";
  options.checkpointSeconds = 1e6;
  ASSERT_FALSE(run(options, 0.05).complete);
  const auto previous = options.checkpointPath + ".previous";
  auto first = results::readCheckpoint(previous).value();
  EXPECT_EQ(std::get<std::vector<double>>(first.find("/rolling/scalars")->values)[0], 0) << "the step";
  setAttribute(first.attributes, "isa", std::string("abacus"));
  writeDurably(previous, results::encodeTree(first));
  writeDurably(options.checkpointPath, "half writ");

  options.resume = true;
  Listener listener(2);
  auto resumed = simulation::runCase(shortCase(), options, listener);
  EXPECT_THAT(listener.messages, HasSubstr("the newest checkpoint is not whole"));
  EXPECT_THAT(listener.messages, HasSubstr("begun on abacus"));
  EXPECT_THAT(listener.phases, Not(Contains("equilibrium")));
  const auto foreign = std::erase_if(
      resumed.warnings, [](const auto& warning) { return warning.find("begun on abacus") != std::string::npos; });
  EXPECT_EQ(foreign, 1u);
  EXPECT_EQ(results::firstDifference(comparable(uninterrupted()), comparable(resumed)), "");
}

TEST(Resume, ACheckpointOfAnotherCaseIsRefused) {
  const TemporaryFolder folder;
  simulation::RunOptions options;
  options.checkpointPath = folder / "run.checkpoint";
  options.resume = true;
  ArrayTree other;
  setAttribute(other.attributes, "case_hash", std::string("00000000"));
  results::writeCheckpoint(options.checkpointPath, other);
  EXPECT_THROW(run(options), CaseError);
}

TEST(Resume, ACheckpointWithoutItsArraysIsRefused) {
  const TemporaryFolder folder;
  simulation::RunOptions options;
  options.checkpointPath = folder / "run.checkpoint";
  options.resume = true;
  ArrayTree hollow;
  setAttribute(hollow.attributes, "case_hash", uninterrupted().caseHash);
  setAttribute(hollow.attributes, "isa", uninterrupted().isa);
  results::writeCheckpoint(options.checkpointPath, hollow);
  EXPECT_THROW(run(options), FileError);
}

}  // namespace
}  // namespace squat
