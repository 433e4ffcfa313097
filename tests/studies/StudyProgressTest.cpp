// What a watcher of a study hears of each run.
#include "studies/StudyProgress.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "TemporaryFolder.h"
#include "studies/StubStudy.h"

namespace squat::studies {
namespace {

using ::testing::HasSubstr;

class WatchedStudy : public testing::Test {
 protected:
  StudyTable compute(const StudyRunner& run, Monitor& monitor) {
    StudyOptions options{folder_ / "study", 1, false};
    options.watcher = [this](const StudyProgress& progress) { heard_.push_back(progress); };
    return runStudy(stubStudy(3, 3), run, options, monitor);
  }
  static auto count(const StudyProgress& progress, RunState state) {
    return std::count_if(progress.runs.begin(), progress.runs.end(),
                         [&](const RunProgress& run) { return run.state == state; });
  }

  const tests::TemporaryFolder folder_;
  std::vector<StudyProgress> heard_;
  Monitor monitor_;
};

TEST_F(WatchedStudy, eachRunWaitsComputesAndEnds) {
  const auto table = compute(stubRun, monitor_);
  // Its beginning, and the begin and the end of nine runs.
  ASSERT_EQ(heard_.size(), 1u + 2 * 9);
  EXPECT_EQ(count(heard_.front(), RunState::waiting), 9);
  EXPECT_EQ(heard_[1].runs[0].state, RunState::computing);
  EXPECT_EQ(count(heard_[1], RunState::waiting), 8);
  EXPECT_EQ(heard_[2].runs[0].state, RunState::done);
  ASSERT_EQ(heard_[2].runs[0].row->features.size(), table.rows[0].features.size());
  EXPECT_EQ(heard_[2].runs[0].row->features[0], table.rows[0].features[0]);
  EXPECT_EQ(count(heard_[2], RunState::waiting), 8);
  const auto& last = heard_.back();
  EXPECT_EQ(count(last, RunState::done), 8);
  EXPECT_EQ(last.runs[4].state, RunState::failed);  // the point 40, 0.2
  EXPECT_THAT(last.runs[4].row->message, HasSubstr("contact lost"));
  EXPECT_EQ(last.definition->variations[1].key, "defect.depth");
  // What was heard first is as it was.
  EXPECT_TRUE(heard_.front().runs[0].row->features.empty());
  EXPECT_EQ(heard_.front().runs[0].row->state, RowState::open);
}

TEST_F(WatchedStudy, aStoppedRunIsCancelledAndTheOthersWait) {
  struct Stopped : Monitor {
    bool cancelled() override { return stopped; }
    bool stopped = false;
  } monitor;
  const auto run = [&](const StudyPoint& point, Monitor& own) -> std::optional<FeatureRow> {
    if (point.index == 2) monitor.stopped = true;  // the user presses Cancel
    if (own.cancelled()) return {};
    return stubRun(point, own);
  };
  compute(run, monitor);
  EXPECT_EQ(count(heard_.back(), RunState::done), 2);
  EXPECT_EQ(heard_.back().runs[2].state, RunState::cancelled);
  EXPECT_EQ(count(heard_.back(), RunState::waiting), 6);
  // Resumed: what was done is so from the beginning.
  heard_.clear();
  compute(stubRun, monitor_);
  EXPECT_EQ(count(heard_.front(), RunState::done), 2);
  EXPECT_EQ(count(heard_.front(), RunState::waiting), 7);
}

// However often a run reports: copying the table must not cost more than the run.
TEST_F(WatchedStudy, fractionsAreToldTenTimesASecondAtMost) {
  using Clock = std::chrono::steady_clock;
  const auto started = Clock::now();
  const auto run = [&](const StudyPoint& point, Monitor& own) {
    Progress progress;
    progress.phase = "rolling";
    for (int i = 0; i < 2000; ++i) {
      progress.fraction = i / 2000.0;
      own.report(progress);
    }
    // So long after the last one that is told, this one is.
    const auto last = heard_.size();
    progress.fraction = 0.75;
    while (point.index == 0 && heard_.size() == last) own.report(progress);
    return stubRun(point, own);
  };
  compute(run, monitor_);
  const std::chrono::duration<double> spent = Clock::now() - started;
  EXPECT_LE(static_cast<double>(heard_.size()), 1 + 2 * 9 + spent.count() / 0.1 + 1);
  const auto told = std::find_if(heard_.begin(), heard_.end(), [](const StudyProgress& progress) {
    return progress.runs[0].state == RunState::computing && progress.runs[0].fraction == 0.75;
  });
  EXPECT_NE(told, heard_.end());
}

}  // namespace
}  // namespace squat::studies
