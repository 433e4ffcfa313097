#include "studies/StudyProgress.h"

namespace squat::studies {

namespace {

constexpr std::chrono::milliseconds kLookAgain{100};

RunState stateOf(RowState state) {
  return state == RowState::done ? RunState::done : state == RowState::failed ? RunState::failed : RunState::waiting;
}

}  // namespace

StudyProgress progressOf(const StudyTable& table) {
  StudyProgress progress{std::make_shared<const StudyDefinition>(table.definition), {}};
  for (const auto& row : table.rows)
    progress.runs.push_back({std::make_shared<const StudyRow>(row), stateOf(row.state), 0});
  return progress;
}

void StudyReporter::begin(const StudyTable& table) {
  if (!watcher_) return;
  seen_ = progressOf(table);
  notify();
}

void StudyReporter::beginRun(std::size_t row) {
  if (!watcher_) return;
  seen_.runs[row].state = RunState::computing;
  seen_.runs[row].fraction = 0;
  notify();
}

void StudyReporter::progress(std::size_t row, double fraction) {
  if (!watcher_) return;
  seen_.runs[row].fraction = fraction;
  if (std::chrono::steady_clock::now() - notified_ >= kLookAgain) notify();
}

void StudyReporter::endRun(std::size_t row, const StudyRow& ended) {
  if (!watcher_) return;
  const auto state = ended.state == RowState::open ? RunState::cancelled : stateOf(ended.state);
  seen_.runs[row] = {std::make_shared<const StudyRow>(ended), state, 0};
  notify();
}

void StudyReporter::notify() {
  notified_ = std::chrono::steady_clock::now();
  watcher_(seen_);
}

}  // namespace squat::studies
