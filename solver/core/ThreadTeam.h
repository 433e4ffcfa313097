// solver/core/ThreadTeam.h - a few threads that work in step.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace squat {

// How long a thread waits awake for the others before it sleeps.
struct SpinPolicy {
  explicit SpinPolicy(int threads);
  // True as soon as `done()` is, false when spins and yields have run out.
  template <typename Done>
  bool waitFor(const Done& done) const;
  int spins, yields;
};

// Barrier for threads that meet every few microseconds: spins a while, then yields, then sleeps, so that a busy machine
// only slows it.
class StepBarrier {
 public:
  explicit StepBarrier(int threads);
  void wait();

 private:
  const int threads_;
  const SpinPolicy spinPolicy_;
  std::atomic<int> arrived_{0};
  std::atomic<unsigned> round_{0};
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
  void run(const std::function<void(int)>& task);
  // body(0) to body(count - 1), each once, in any order: a thread takes the next when it has done one.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& body);
  // For use inside a task: all threads of the team must come.
  void barrier() { barrier_.wait(); }

 private:
  void work(int index);
  void end();
  int size_;
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
