// solver/core/ThreadTeam.h - a few threads that work in step.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <initializer_list>
#include <mutex>
#include <thread>
#include <vector>

namespace squat {

// Whether other programs take cores from the team, seen from how often its threads lost theirs.
class CoreContention {
 public:
  bool isDetected() const { return affected_.load(std::memory_order_relaxed) > 0; }
  // Of one thread, which is to look every few milliseconds.
  class Watch {
   public:
    void look(CoreContention& contention);

   private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point since_ = Clock::now();
    long lost_ = -1;
    bool counted_ = false;  // among those that lose their core
  };

 private:
  std::atomic<int> affected_{0};  // threads that lose their core often
};

// How long a thread of a team waits awake for the others before it sleeps. Threads that have a core each meet within
// microseconds, and a core that goes to sleep takes longer to wake than most waits last, on virtual machines above all.
// But where another program holds a core, the thread that is waited for cannot come before its turn, some milliseconds:
// only the core of the waiting thread, given away, lets it come sooner.
class SpinPolicy {
 public:
  SpinPolicy(int threads, const CoreContention& contention);
  // True as soon as `done()` is, false when it is time to sleep.
  template <typename Done>
  bool waitFor(const Done& done) const;

 private:
  const CoreContention& contention_;
  int spins_, yields_;
};

// Barrier for threads that meet every few microseconds: waits as its SpinPolicy says, then sleeps, so that a busy
// machine only slows it.
class StepBarrier {
 public:
  StepBarrier(int threads, const CoreContention& contention);
  void wait();

 private:
  const int threads_;
  const SpinPolicy spinPolicy_;
  alignas(64) std::atomic<int> arrived_{0};
  alignas(64) std::atomic<unsigned> round_{0};
};

// Whether the calling thread does the parts of all threads itself: while other programs hold cores, waiting for a
// thread that has none may take longer than its part. Decided from measured times, for 0.1 s at first and 1.6 s at
// most; then all threads are tried again.
class SerialFallback {
 public:
  using Clock = std::chrono::steady_clock;
  bool isOn(Clock::time_point now = Clock::now()) const { return isOn_ && now < until_; }
  // All threads together took `wall` by the clock for parts that cost `work` of processor time.
  void note(std::chrono::nanoseconds wall, std::chrono::nanoseconds work, Clock::time_point now = Clock::now());

 private:
  static constexpr std::chrono::milliseconds shortest{100}, longest{1600};
  bool isOn_ = false;
  Clock::time_point until_;
  std::chrono::nanoseconds wall_{}, work_{};
  std::chrono::milliseconds next_ = shortest;
};

// Runs a task on all threads (the caller is thread 0) and returns when all are done. An exception in a task is passed
// on.
class ThreadTeam {
 public:
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return size_; }
  // Parts that do not wait for each other: the caller does all of them where that is quicker.
  void run(const std::function<void(int)>& task);
  // The same, phase by phase: none begins before the one before it has ended on all threads.
  void runInOrder(std::initializer_list<std::function<void(int)>> phases);
  // Parts that meet at barriers of their own.
  void runInStep(const std::function<void(int)>& task);
  // body(0) to body(count - 1), each once, in any order: a thread takes the next when it has done one.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& body);
  // For use inside a task of runInStep(): all threads of the team must come.
  void barrier() { barrier_.wait(); }

 private:
  void work(int index);
  void end();
  int size_;
  SerialFallback fallback_;
  CoreContention contention_;
  CoreContention::Watch callersWatch_;
  SpinPolicy spinPolicy_;
  StepBarrier barrier_;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable start_, done_;
  const std::function<void(int)>* task_ = nullptr;
  std::atomic<unsigned long> round_{0};  // changed under the mutex, as are the next two; read outside while spinning
  std::atomic<int> busy_{0};
  std::atomic<bool> stop_{false};
  std::exception_ptr failure_;
};

// Number of threads for a wish of the user; 0 or less: that of the environment variable SQUAT_THREADS, else all cores.
// Throws CaseError where the variable is not a whole number of at least 1.
int threadCount(int requested);

}  // namespace squat
