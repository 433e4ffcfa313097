// widgets/studio/runs/WorkerMonitor.h - between the computing thread and the window: progress out, wishes in.
#pragma once

#include <QString>
#include <QStringList>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

#include "core/Monitor.h"

namespace squat::studio {

// A point of the live curves.
struct LiveSample {
  double time = 0, position = 0;    // [s], [m]
  double axleBoxAcceleration = 0;   // [m/s2]
  double contactForce = 0;          // [N]
  double accelerationPosition = 0;  // [m] of the wheel at the instant of the acceleration
};

// report() and message() are called by the computing thread, takeNews() by the window a few times a second: nothing is
// queued, so a fast computation cannot flood the event loop. The live curves are thinned out beyond `maximumSamples`.
class WorkerMonitor : public Monitor {
 public:
  static constexpr std::size_t maximumSamples = 20000;

  void report(const Progress& progress) override;
  void message(const std::string& text) override;
  bool cancelled() override;  // waits while paused
  bool paused() override;     // sleeps up to 20 ms while paused, so that the asking thread does not spin

  // What stands so far, as a call that shows it in the window's thread. It holds values of its own, which nobody
  // changes. Only the last one that was not taken yet counts.
  void show(std::function<void()> soFar);

  void cancel();
  void setPaused(bool paused);
  bool isCancelled() const { return cancel_; }
  bool isPaused() const { return pause_; }

  struct News {
    Progress progress;
    QStringList messages;
    std::vector<LiveSample> samples;  // since the last call
    std::function<void()> show;       // empty: nothing new
  };
  News takeNews();

 private:
  std::atomic<bool> cancel_{false}, pause_{false};
  std::mutex mutex_;
  std::condition_variable wake_;
  News news_;
  std::size_t reports_ = 0, taken_ = 0;
};

}  // namespace squat::studio
