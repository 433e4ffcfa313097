#include "studies/RunStudy.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "studies/StudyIdentity.h"

namespace squat::studies {
namespace {

std::string oneLine(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  return text;
}

class Study {
 public:
  Study(StudyTable table, const StudyRunner& runner, const StudyOptions& options, PartLock* lock, Monitor& monitor)
      : table_(std::move(table)),
        runner_(runner),
        options_(options),
        lock_(lock),
        monitor_(monitor),
        reporter_(options.watcher) {
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      auto& row = table_.rows[i];
      if (row.state == RowState::failed && options.retryFailed) row = {row.point, RowState::open, {}, {}};
      if (row.state == RowState::open) open_.push_back(i);
    }
    reporter_.begin(table_);
  }

  StudyTable run() {
    const std::size_t workers =
        std::min<std::size_t>(static_cast<std::size_t>(std::max(options_.jobs, 1)), open_.size());
    fractions_.assign(workers, 0.0);
    {
      std::vector<std::jthread> helpers;
      for (std::size_t w = 1; w < workers; ++w) helpers.emplace_back([this, w] { work(w); });
      if (workers > 0) work(0);
    }
    if (error_) std::rethrow_exception(error_);
    return std::move(table_);
  }

 private:
  // What a single run sees of the study's monitor.
  class RunMonitor : public Monitor {
   public:
    RunMonitor(Study& study, std::size_t worker, std::size_t row, std::string name)
        : study_(study), worker_(worker), row_(row), name_(std::move(name)) {}
    void report(const Progress& progress) override {
      const std::lock_guard lock(study_.mutex_);
      if (progress.phase == "rolling") study_.fractions_[worker_] = progress.fraction;
      if (progress.phase == "growth" && progress.remainingSeconds >= 0)
        study_.fractions_[worker_] = shareOfTime(progress.remainingSeconds);
      study_.reporter_.progress(row_, study_.fractions_[worker_]);
      study_.reportLocked(progress);
    }
    void message(const std::string& text) override {
      const std::lock_guard lock(study_.mutex_);
      study_.monitor_.message(name_ + ": " + text);
    }
    bool cancelled() override {
      const std::lock_guard lock(study_.mutex_);
      return study_.stopped_ || study_.monitor_.cancelled();
    }
    bool paused() override {
      const std::lock_guard lock(study_.mutex_);
      return study_.monitor_.paused();
    }

   private:
    // The blocks of a growth become longer: its tonnage says little about its time.
    double shareOfTime(double remaining) const {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
      return elapsed.count() / (elapsed.count() + remaining);
    }

    Study& study_;
    std::size_t worker_, row_;
    std::string name_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };

  void reportLocked(Progress progress) {
    const std::size_t done = table_.rows.size() - table_.count(RowState::open);
    double ended = static_cast<double>(done);
    for (const double fraction : fractions_) ended += fraction;
    progress.phase = std::to_string(done) + " of " + std::to_string(table_.rows.size()) + " runs done";
    progress.fraction = ended / static_cast<double>(table_.rows.size());
    progress.remainingSeconds = remainingSeconds(progress.fraction);
    monitor_.report(progress);
  }

  // From the time that the share computed so far took, once that is a fiftieth: below zero before.
  double remainingSeconds(double fraction) const {
    constexpr double least = 0.02;
    const double before = 1 - static_cast<double>(open_.size()) / static_cast<double>(table_.rows.size());
    if (fraction - before < least) return -1;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    return elapsed.count() * (1 - fraction) / (fraction - before);
  }

  // The next open point; nothing where all are taken or the study was stopped.
  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    if (stopped_ || next_ >= open_.size() || monitor_.cancelled()) return std::nullopt;
    reporter_.beginRun(open_[next_]);
    return open_[next_++];
  }

  void work(std::size_t worker) {
    try {
      while (const auto index = take()) end(worker, outcomeOf(worker, *index), *index);
    } catch (...) {  // the table could not be written
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      stopped_ = true;
    }
  }

  StudyRow outcomeOf(std::size_t worker, std::size_t index) {
    StudyRow row = table_.rows[index];  // its own point never changes
    RunMonitor monitor(*this, worker, index, toText(table_.definition, row.point));
    try {
      if (auto features = runner_(row.point, monitor)) {
        row.state = RowState::done;
        row.features = std::move(*features);
      }
    } catch (const std::exception& error) {
      row.state = RowState::failed;
      row.message = oneLine(error.what());
    } catch (...) {
      row.state = RowState::failed;
      row.message = "unknown error";
    }
    return row;
  }

  void end(std::size_t worker, StudyRow row, std::size_t index) {
    const std::lock_guard lock(mutex_);
    fractions_[worker] = 0;
    reporter_.endRun(index, row);
    if (row.state == RowState::open) return;
    const std::string name = toText(table_.definition, row.point);
    monitor_.message(name + (row.state == RowState::done ? ": done" : ": failed: " + row.message));
    table_.rows[index] = std::move(row);
    if (lock_) lock_->requireOwn();
    writeTable(table_, options_.folder);
    reportLocked({});
  }

  StudyTable table_;
  const StudyRunner& runner_;
  const StudyOptions& options_;
  PartLock* lock_;  // null: a study without parts
  Monitor& monitor_;
  StudyReporter reporter_;
  std::mutex mutex_;
  std::vector<std::size_t> open_;
  std::vector<double> fractions_;  // of the runs under way, one a worker
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t next_ = 0;
  bool stopped_ = false;
  std::exception_ptr error_;
};

}  // namespace

StudyTable runStudy(const StudyDefinition& definition, const StudyRunner& runner, const StudyOptions& options,
                    Monitor& monitor) {
  makeFolder(options.folder);
  std::optional<PartLock> lock;
  if (options.part) {
    claimParts(definition, *options.part, options.folder);
    lock.emplace("study", *options.part, options.folder, options.beat, monitor);
  } else if (partsIn(definition, options.folder) && !hasIdentity(definition, options.folder)) {
    throw CaseError({{"-o", options.folder, "a folder without parts of a study",
                      "Collect them with --collect, or choose another folder"}});
  }
  auto table = emptyTable(definition, options.part);
  if (auto earlier = readTable(definition, options.folder, options.part)) table = std::move(*earlier);
  writeTable(table, options.folder);
  return Study(std::move(table), runner, options, lock ? &*lock : nullptr, monitor).run();
}

}  // namespace squat::studies
