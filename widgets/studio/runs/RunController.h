// widgets/studio/runs/RunController.h - runs one case at a time in a thread of its own.
#pragma once

#include <QObject>
#include <exception>
#include <functional>
#include <memory>

#include "case/CaseDescription.h"
#include "core/Errors.h"
#include "results/RunResult.h"
#include "simulation/RunCase.h"
#include "studio/runs/BackgroundJob.h"

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
  bool isRunning() const { return job_.isRunning(); }
  bool isPaused() const { return job_.isPaused(); }
  bool isResumed() const { return resumed_; }  // the run in progress, or the last one
  bool isStopping() const { return job_.isStopping(); }
  void setPaused(bool paused) { job_.setPaused(paused); }
  void cancel() { job_.cancel(); }  // returns at once; finished() follows
  // Runs the event loop until the run has ended.
  bool waitFor(int milliseconds) { return job_.waitFor(milliseconds); }

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
  void conclude(const std::exception_ptr& error);

  Runner runner_;
  bool resumed_ = false;
  std::shared_ptr<Outcome> outcome_;
  BackgroundJob job_;  // the last one: its thread uses what stands above
};

}  // namespace squat::studio

Q_DECLARE_METATYPE(squat::studio::ResultPointer)
