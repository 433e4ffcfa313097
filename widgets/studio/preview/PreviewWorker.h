// widgets/studio/preview/PreviewWorker.h - the thread that computes previews: the newest wish counts. Knows no window.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "studio/preview/PreviewStart.h"

namespace squat::studio {

class PreviewWorker {
 public:
  // `changed` is called on the thread whenever there is something new to take(); it has to be quick.
  PreviewWorker(PreviewSolver solver, int threads, std::function<void()> changed);
  ~PreviewWorker();  // cancels and waits
  PreviewWorker(const PreviewWorker&) = delete;
  PreviewWorker& operator=(const PreviewWorker&) = delete;

  // Returns at once. What is under way for an earlier wish stops, except a state that serves the new one too. Null:
  // nothing is wished for. The states are kept. While wishes come faster than they can be served, every now and then
  // one of them is rolled to behind its defect first: a drag is not blind.
  void ask(std::shared_ptr<const cases::CaseDescription> open);
  Preview take() const;
  bool isBusy() const { return busy_; }

 private:
  struct Wish {
    std::shared_ptr<const cases::CaseDescription> open;
    unsigned long number = 0;
  };
  class StartMonitor;
  class RollMonitor;

  void work();
  void serve(const Wish& wish);
  void preview(const Wish& wish);
  results::RunResult roll(const Wish& wish, const cases::CaseDescription& description,
                          std::shared_ptr<const simulation::WarmState> state);
  bool isNewest(const Wish& wish) const { return newest_ == wish.number; }
  Wish newest() const;
  bool mayPublish(const Wish& wish) const;  // under the mutex
  void publish(const Wish& wish, Preview preview);
  void refuse(const Wish& wish, const std::string& sentence);

  const PreviewSolver solver_;
  const int threads_;
  const std::function<void()> changed_;
  PreviewStart start_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Wish wish_;
  Preview latest_;
  bool closing_ = false;
  // Of the thread alone: when a defect was last seen, and a wish that is rolled on though there is a newer one.
  std::chrono::steady_clock::time_point lastSeen_{};
  unsigned long patientFor_ = 0;
  std::atomic<unsigned long> newest_{0};
  std::atomic<bool> busy_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace squat::studio
