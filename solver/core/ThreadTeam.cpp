#include "core/ThreadTeam.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include "core/Errors.h"
#include "core/platform/Threads.h"

namespace squat {

// Another program that computes takes its turn every few milliseconds; what the system itself does is rarer.
void CoreContention::Watch::look(CoreContention& contention) {
  constexpr auto window = std::chrono::milliseconds(30);
  constexpr long often = 3;
  const auto now = Clock::now();
  if (lost_ >= 0 && now - since_ < window) return;
  const long lost = platform::timesCoreWasLost();
  const bool isOften = lost_ >= 0 && lost - lost_ >= often;
  if (isOften != counted_) contention.affected_ += isOften ? 1 : -1;
  counted_ = isOften, lost_ = lost, since_ = now;
}

SpinPolicy::SpinPolicy(int threads, const CoreContention& contention)
    : contention_(contention),
      spins_(threads <= static_cast<int>(std::thread::hardware_concurrency()) ? 2000 : 20),
      yields_(threads <= static_cast<int>(std::thread::hardware_concurrency()) ? 1000 : 0) {}

template <typename Done>
bool SpinPolicy::waitFor(const Done& done) const {
  const bool contended = contention_.isDetected();
  const int spins = contended ? std::min(spins_, 100) : spins_, yields = contended ? 0 : yields_;
  for (int i = 0; i < spins; ++i) {
    if (done()) return true;
    platform::pauseOfAWait();
  }
  for (int i = 0; i < yields; ++i) {
    if (done()) return true;
    std::this_thread::yield();
  }
  return false;
}

void StepBarrier::wait() {
  if (threads_ == 1) return;
  const unsigned round = round_.load(std::memory_order_relaxed);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
    arrived_.store(0, std::memory_order_relaxed);
    round_.store(round + 1, std::memory_order_release);
    platform::wakeWaiting(round_);
    return;
  }
  if (spinPolicy_.waitFor([&] { return round_.load(std::memory_order_acquire) != round; })) return;
  while (round_.load(std::memory_order_acquire) == round) platform::waitWhile(round_, round);
}

StepBarrier::StepBarrier(int threads, const CoreContention& contention)
    : threads_(threads), spinPolicy_(threads, contention) {}

void SerialFallback::note(std::chrono::nanoseconds wall, std::chrono::nanoseconds work, Clock::time_point now) {
  constexpr std::chrono::milliseconds window{20};  // long against the turns in which programs share a core
  wall_ += wall, work_ += work;
  if (wall_ < window) return;
  isOn_ = wall_ > work_;
  until_ = now + next_;
  next_ = isOn_ ? std::min(longest, 2 * next_) : shortest;
  wall_ = work_ = {};
}

ThreadTeam::ThreadTeam(int threads)
    : size_(std::max(1, threads)), spinPolicy_(size_, contention_), barrier_(size_, contention_) {
  try {
    for (int i = 1; i < size_; ++i) threads_.emplace_back([this, i] { work(i); });
  } catch (...) {  // no more threads to be had: those that run must end before they are let go
    end();
    throw;
  }
}

ThreadTeam::~ThreadTeam() { end(); }

void ThreadTeam::end() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  start_.notify_all();
  for (auto& thread : threads_) thread.join();
}

void ThreadTeam::run(const std::function<void(int)>& task) { runInOrder({task}); }

void ThreadTeam::runInOrder(std::initializer_list<std::function<void(int)>> phases) {
  if (size_ == 1 || fallback_.isOn()) {
    for (const auto& phase : phases)
      for (int index = 0; index < size_; ++index) phase(index);
    return;
  }
  const auto inStep = [&](int index) {
    for (const auto* phase = phases.begin(); phase != phases.end(); ++phase) {
      if (phase != phases.begin()) barrier_.wait();
      (*phase)(index);
    }
  };
  if (!contention_.isDetected()) return runInStep(inStep);
  std::atomic<long long> work{0};  // [ns]
  const auto begun = std::chrono::steady_clock::now();
  runInStep([&](int index) {
    const auto own = platform::processorTime();
    inStep(index);
    work += (platform::processorTime() - own).count();
  });
  fallback_.note(std::chrono::steady_clock::now() - begun, std::chrono::nanoseconds(work));
}

void ThreadTeam::runInStep(const std::function<void(int)>& task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    busy_ = size_ - 1;
    ++round_;
  }
  start_.notify_all();
  std::exception_ptr own;
  try {
    task(0);
  } catch (...) {
    own = std::current_exception();
  }
  const auto allDone = [this] { return busy_ == 0; };
  callersWatch_.look(contention_);
  spinPolicy_.waitFor(allDone);
  std::unique_lock lock(mutex_);
  done_.wait(lock, allDone);
  task_ = nullptr;
  const auto failure = own ? own : std::exchange(failure_, nullptr);
  if (failure) std::rethrow_exception(failure);
}

void ThreadTeam::work(int index) {
  unsigned long seen = 0;
  CoreContention::Watch watch;
  const auto called = [&] { return stop_ || round_ != seen; };
  while (true) {
    const std::function<void(int)>* task = nullptr;
    watch.look(contention_);
    spinPolicy_.waitFor(called);
    {
      std::unique_lock lock(mutex_);
      start_.wait(lock, called);
      if (stop_) return;
      seen = round_;
      task = task_;
    }
    try {
      (*task)(index);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    {
      const std::lock_guard lock(mutex_);
      --busy_;
    }
    done_.notify_one();
  }
}

void ThreadTeam::forEach(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  run([&](int) {
    for (std::size_t i = next++; i < count; i = next++) body(i);
  });
}

int threadCount(int requested) {
  if (requested > 0) return requested;
  if (const char* given = std::getenv("SQUAT_THREADS")) {
    int count = 0;
    const std::string_view text = given;
    const auto* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, count).ptr != end || count < 1)
      throw CaseError({{"SQUAT_THREADS", given, "a whole number of at least 1", "Correct the environment variable"}});
    return count;
  }
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace squat
