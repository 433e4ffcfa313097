#include "estimation/ProfileRuns.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

namespace squat::estimation {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

// A run under way asks only whether to stop: the search reports for all of them.
class ProfileRuns::RunMonitor : public Monitor {
 public:
  explicit RunMonitor(ProfileRuns& runs) : runs_(runs) {}
  bool cancelled() override {
    const std::lock_guard lock(runs_.mutex_);
    return runs_.monitor_.cancelled();
  }
  bool paused() override {
    const std::lock_guard lock(runs_.mutex_);
    return runs_.monitor_.paused();
  }

 private:
  ProfileRuns& runs_;
};

ProfileRuns::ProfileRuns(const std::vector<PassageModel>& models, int jobs, int planned, Monitor& monitor)
    : models_(models), jobs_(jobs), planned_(planned), started_(now()), monitor_(monitor) {}

// With the mutex held.
void ProfileRuns::report() {
  Progress progress;
  progress.phase = phase_;
  const int all = std::max(planned_, done_);
  progress.fraction = all > 0 ? static_cast<double>(done_) / all : 0;
  if (done_ > 0) progress.remainingSeconds = (now() - started_) / done_ * (all - done_);
  monitor_.report(progress);
}

std::vector<Response> ProfileRuns::all(const std::vector<ProfilePoints>& profiles) {
  const std::size_t count = profiles.size() * models_.size();
  std::vector<std::optional<PositionSeries>> series(count);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        RunMonitor own(*this);
        series[i] = models_[i % models_.size()].run(profiles[i / models_.size()], own);
        const std::lock_guard lock(mutex_);
        ++done_;
        report();
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int job = 1; job < jobs_; ++job) helpers.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
  std::vector<Response> responses(profiles.size());
  for (std::size_t p = 0; p < profiles.size(); ++p) {
    const auto first = series.begin() + static_cast<std::ptrdiff_t>(p * models_.size());
    const auto last = first + static_cast<std::ptrdiff_t>(models_.size());
    if (!std::all_of(first, last, [](const auto& each) { return each.has_value(); })) continue;
    responses[p].emplace();
    for (auto each = first; each != last; ++each) responses[p]->push_back(std::move(**each));
  }
  return responses;
}

}  // namespace squat::estimation
