#include "studio/runs/WorkerMonitor.h"

#include <chrono>
#include <utility>

namespace squat::studio {

void WorkerMonitor::report(const Progress& progress) {
  const std::lock_guard lock(mutex_);
  Progress latest = progress;
  if (!(latest.step > 0)) {  // reported once: later phases do not repeat it
    latest.step = news_.progress.step;
    latest.limitedBy = news_.progress.limitedBy;
  }
  news_.progress = std::move(latest);
  if (progress.phase != "rolling" || !(progress.simulatedTime > 0)) return;  // the phase is reported before it begins
  // Every report until the curves are long, then every second, fourth ...
  const std::size_t stride = std::size_t{1} << (taken_ / maximumSamples);
  if (reports_++ % stride != 0) return;
  ++taken_;
  news_.samples.push_back({progress.simulatedTime, progress.position, progress.axleBoxAcceleration,
                           progress.contactForce, progress.accelerationPosition});
}

void WorkerMonitor::message(const std::string& text) {
  const std::lock_guard lock(mutex_);
  news_.messages << QString::fromStdString(text);
}

// What it replaces goes after the lock is given back: it may hold much.
void WorkerMonitor::show(std::function<void()> soFar) {
  const std::lock_guard lock(mutex_);
  news_.show.swap(soFar);
}

// Phases before the rolling ask only this: a pause holds them here.
bool WorkerMonitor::cancelled() {
  while (paused()) continue;
  return cancel_;
}

bool WorkerMonitor::paused() {
  if (!pause_ || cancel_) return false;
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return !pause_ || cancel_; });
  return pause_ && !cancel_;
}

void WorkerMonitor::cancel() {
  cancel_ = true;
  wake_.notify_all();
}

void WorkerMonitor::setPaused(bool paused) {
  pause_ = paused;
  wake_.notify_all();
}

WorkerMonitor::News WorkerMonitor::takeNews() {
  const std::lock_guard lock(mutex_);
  News news = news_;
  news_.messages.clear();
  news_.samples.clear();
  news_.show = nullptr;
  return news;
}

}  // namespace squat::studio
