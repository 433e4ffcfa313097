// solver/studies/StudyProgress.h - how far each run of a study is, for whoever watches.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "studies/StudyTable.h"

namespace squat::studies {

enum class RunState { waiting, computing, done, failed, cancelled };

struct RunProgress {
  std::shared_ptr<const StudyRow> row;  // of a run that computes: as it stood before
  RunState state = RunState::waiting;
  double fraction = 0;  // 0..1 of the rolling, while it computes
};

// A value: what it points to is never changed, so that any thread may keep it.
struct StudyProgress {
  std::shared_ptr<const StudyDefinition> definition;
  std::vector<RunProgress> runs;  // one a row of the table, in its order
};

using StudyWatcher = std::function<void(const StudyProgress&)>;

// Of a table that nobody computes.
StudyProgress progressOf(const StudyTable& table);

// Notifies a watcher what changes: the state of a run always, its fraction at most ten times a second. Called under a
// lock of its owner. Does nothing without a watcher.
class StudyReporter {
 public:
  explicit StudyReporter(StudyWatcher watcher) : watcher_(std::move(watcher)) {}

  void begin(const StudyTable& table);
  void beginRun(std::size_t row);
  void progress(std::size_t row, double fraction);
  void endRun(std::size_t row, const StudyRow& ended);  // open: cancelled

 private:
  void notify();

  StudyWatcher watcher_;
  StudyProgress seen_;
  std::chrono::steady_clock::time_point notified_ = {};
};

}  // namespace squat::studies
