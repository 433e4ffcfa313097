// widgets/studio/runs/BackgroundJob.h - one long computation at a time, in a thread of its own, watched by the window.
#pragma once

#include <QObject>
#include <QTimer>
#include <exception>
#include <functional>
#include <memory>
#include <thread>

#include "studio/runs/WorkerMonitor.h"

namespace squat::studio {

class BackgroundJob : public QObject {
  Q_OBJECT
 public:
  // Called in the job's thread. What it throws comes back with ended().
  using Work = std::function<void(WorkerMonitor&)>;

  explicit BackgroundJob(QObject* parent = nullptr);
  ~BackgroundJob() override;  // cancels and waits

  void start(Work work);  // does nothing while one is going on
  bool isRunning() const { return running_; }
  bool isPaused() const { return monitor_ && monitor_->isPaused(); }
  bool isStopping() const { return running_ && monitor_->isCancelled(); }
  void setPaused(bool paused);
  void cancel();                   // returns at once; ended() follows
  bool waitFor(int milliseconds);  // runs the event loop until the job has ended

 Q_SIGNALS:
  void started();
  void stopping();  // cancelled, not yet over
  void pausedChanged(bool paused);
  void news(const squat::studio::WorkerMonitor::News& news);  // about 20 times a second
  void ended(const std::exception_ptr& error);                // null: it returned

 private:
  void conclude();
  void passNews();

  std::unique_ptr<WorkerMonitor> monitor_;
  std::exception_ptr error_;
  std::thread thread_;
  QTimer timer_;
  bool running_ = false;
};

}  // namespace squat::studio

Q_DECLARE_METATYPE(squat::studio::WorkerMonitor::News)
