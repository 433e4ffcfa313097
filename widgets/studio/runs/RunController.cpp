#include "studio/runs/RunController.h"

#include <QElapsedTimer>
#include <QEventLoop>

#include "core/Errors.h"
#include "studio/common/ThreadPriority.h"

namespace squat::studio {

struct RunController::Outcome {
  results::RunResult result, partial;
  std::exception_ptr error;
};

namespace {

struct Description {
  QString sentence, details;
  std::vector<CaseProblem> problems;  // of the case, where it is that
};

Description describe(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const CaseError& wrong) {
    QStringList lines;
    for (const auto& problem : wrong.problems()) lines << QString::fromStdString(toText(problem));
    return {QObject::tr("Invalid case: %1").arg(lines.value(0)), lines.join('\n'), wrong.problems()};
  } catch (const RunError& failure) {
    return {QObject::tr("The run failed: %1").arg(QString::fromStdString(failure.what())),
            QObject::tr("step %1, %2 ms, %3")
                .arg(failure.step())
                .arg(failure.time() * 1e3, 0, 'g', 6)
                .arg(QString::fromStdString(failure.location())),
            {}};
  } catch (const std::bad_alloc&) {
    return {QObject::tr("The run failed: not enough memory. Choose a coarser mesh or a shorter track."), {}, {}};
  } catch (const std::exception& other) {
    return {QObject::tr("The run failed: %1").arg(QString::fromStdString(other.what())), {}, {}};
  }
}

}  // namespace

RunController::RunController(Runner runner, QObject* parent) : QObject(parent), runner_(std::move(runner)) {
  timer_.setInterval(50);
  connect(&timer_, &QTimer::timeout, this, &RunController::passNews);
}

RunController::~RunController() {
  if (monitor_) monitor_->cancel();
  if (thread_.joinable()) thread_.join();
}

void RunController::start(const cases::CaseDescription& description, const std::string& stem,
                          const simulation::RunOptions& options,
                          const std::function<void(const results::RunResult&)>& keep) {
  if (running_) return;
  running_ = true;
  monitor_ = std::make_unique<WorkerMonitor>();
  outcome_ = std::make_unique<Outcome>();
  thread_ = std::thread([this, description, stem, options, keep] {
    giveWayToTheWindow();
    try {
      outcome_->result = runner_(description, options, *monitor_, &outcome_->partial);
      outcome_->result.stem = stem;
      if (outcome_->result.title.empty()) outcome_->result.title = description.title;
    } catch (...) {
      outcome_->error = std::current_exception();
      outcome_->partial.stem = stem;
    }
    try {
      if (keep && !outcome_->error) keep(outcome_->result);
    } catch (...) {
      // The result is there all the same.
    }
    QMetaObject::invokeMethod(this, &RunController::conclude, Qt::QueuedConnection);
  });
  timer_.start();
  Q_EMIT started();
}

void RunController::setPaused(bool paused) {
  if (!running_) return;
  monitor_->setPaused(paused);
  Q_EMIT pausedChanged(paused);
}

void RunController::cancel() {
  if (!running_ || monitor_->isCancelled()) return;
  monitor_->cancel();
  Q_EMIT stopping();
}

void RunController::passNews() {
  if (monitor_) Q_EMIT news(monitor_->takeNews());
}

void RunController::conclude() {
  if (!running_) return;
  thread_.join();
  timer_.stop();
  passNews();
  running_ = false;
  const auto outcome = std::move(outcome_);
  if (outcome->error) {
    const Description text = describe(outcome->error);
    ResultPointer soFar;
    if (!outcome->partial.time.empty()) {
      outcome->partial.complete = false;
      soFar = std::make_shared<const results::RunResult>(std::move(outcome->partial));
    }
    if (!text.problems.empty()) Q_EMIT refused(text.problems);
    Q_EMIT failed(text.sentence, text.details, soFar);
  } else {
    Q_EMIT finished(std::make_shared<const results::RunResult>(std::move(outcome->result)));
  }
  Q_EMIT ended();
}

bool RunController::waitFor(int milliseconds) {
  if (!running_) return true;
  QEventLoop loop;
  connect(this, &RunController::ended, &loop, &QEventLoop::quit);
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
  return !running_;
}

}  // namespace squat::studio
