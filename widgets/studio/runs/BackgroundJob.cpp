#include "studio/runs/BackgroundJob.h"

#include <utility>

#include "core/platform/Threads.h"
#include "studio/common/WaitForSignal.h"

namespace squat::studio {

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
  timer_.setInterval(50);
  connect(&timer_, &QTimer::timeout, this, &BackgroundJob::passNews);
}

BackgroundJob::~BackgroundJob() {
  if (monitor_) monitor_->cancel();
  if (thread_.joinable()) thread_.join();
}

void BackgroundJob::start(Work work) {
  if (running_) return;
  running_ = true;
  monitor_ = std::make_unique<WorkerMonitor>();
  error_ = nullptr;
  thread_ = std::thread([this, work = std::move(work)] {
    platform::giveWay();  // to the window
    try {
      work(*monitor_);
    } catch (...) {
      error_ = std::current_exception();
    }
    QMetaObject::invokeMethod(this, &BackgroundJob::conclude, Qt::QueuedConnection);
  });
  timer_.start();
  Q_EMIT started();
}

void BackgroundJob::setPaused(bool paused) {
  if (!running_) return;
  monitor_->setPaused(paused);
  Q_EMIT pausedChanged(paused);
}

void BackgroundJob::cancel() {
  if (!running_ || monitor_->isCancelled()) return;
  monitor_->cancel();
  Q_EMIT stopping();
}

void BackgroundJob::passNews() {
  if (monitor_) Q_EMIT news(monitor_->takeNews());
}

void BackgroundJob::conclude() {
  if (!running_) return;
  thread_.join();
  timer_.stop();
  passNews();
  running_ = false;
  Q_EMIT ended(std::exchange(error_, nullptr));
}

bool BackgroundJob::waitFor(int milliseconds) {
  if (running_) waitForSignal(this, &BackgroundJob::ended, milliseconds);
  return !running_;
}

}  // namespace squat::studio
