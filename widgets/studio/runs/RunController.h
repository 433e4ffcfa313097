// widgets/studio/runs/RunController.h - runs one case at a time in a thread of its own.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <thread>

#include "case/CaseDescription.h"
#include "core/Errors.h"
#include "results/RunResult.h"
#include "simulation/RunCase.h"
#include "studio/runs/WorkerMonitor.h"

namespace squat::studio {

// How a case is run: simulation::runCase in the program, a made-up run in tests.
using Runner = std::function<results::RunResult(const cases::CaseDescription&, const simulation::RunOptions&, Monitor&,
                                                results::RunResult*)>;
using ResultPointer = std::shared_ptr<const results::RunResult>;

class RunController : public QObject {
  Q_OBJECT
 public:
  explicit RunController(Runner runner, QObject* parent = nullptr);
  ~RunController() override;  // cancels and waits

  // The result carries `stem` and the case's title; `keep` gets it in the run's own thread, before finished(). Does
  // nothing while a run is going on.
  void start(const cases::CaseDescription& description, const std::string& stem,
             const simulation::RunOptions& options = {},
             const std::function<void(const results::RunResult&)>& keep = nullptr);
  bool isRunning() const { return running_; }
  bool isPaused() const { return monitor_ && monitor_->isPaused(); }
  bool isStopping() const { return running_ && monitor_->isCancelled(); }
  void setPaused(bool paused);
  void cancel();                   // returns at once; finished() follows
  bool waitFor(int milliseconds);  // runs the event loop until the run has ended

 Q_SIGNALS:
  void started();
  void stopping();  // cancelled, not yet over
  void pausedChanged(bool paused);
  void news(const squat::studio::WorkerMonitor::News& news);  // about 20 times a second
  // Complete or cancelled (result->complete).
  void finished(squat::studio::ResultPointer result);
  // The case turned out to be none that can be run; failed() follows.
  void refused(const std::vector<squat::CaseProblem>& problems);
  // What failed and why, in one sentence; details for those who ask; what there was so far (may be null).
  void failed(const QString& sentence, const QString& details, squat::studio::ResultPointer soFar);
  void ended();  // after finished() or failed()

 private:
  struct Outcome;
  void conclude();
  void passNews();

  Runner runner_;
  std::unique_ptr<WorkerMonitor> monitor_;
  std::unique_ptr<Outcome> outcome_;
  std::thread thread_;
  QTimer timer_;
  bool running_ = false;
};

}  // namespace squat::studio

Q_DECLARE_METATYPE(squat::studio::ResultPointer)
Q_DECLARE_METATYPE(squat::studio::WorkerMonitor::News)
