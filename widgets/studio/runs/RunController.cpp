#include "studio/runs/RunController.h"

#include <utility>

#include "studio/common/ErrorText.h"

namespace squat::studio {

struct RunController::Outcome {
  results::RunResult result, partial;
};

RunController::RunController(Runner runner, QObject* parent) : QObject(parent), runner_(std::move(runner)) {
  connect(&job_, &BackgroundJob::started, this, &RunController::started);
  connect(&job_, &BackgroundJob::stopping, this, &RunController::stopping);
  connect(&job_, &BackgroundJob::pausedChanged, this, &RunController::pausedChanged);
  connect(&job_, &BackgroundJob::news, this, &RunController::news);
  connect(&job_, &BackgroundJob::ended, this, &RunController::conclude);
}

RunController::~RunController() = default;

void RunController::start(const cases::CaseDescription& description, const std::string& stem,
                          const simulation::RunOptions& options,
                          const std::function<void(const results::RunResult&)>& keep) {
  if (isRunning()) return;
  resumed_ = options.resume;
  outcome_ = std::make_shared<Outcome>();
  job_.start([this, description, stem, options, keep, outcome = outcome_](Monitor& monitor) {
    try {
      outcome->result = runner_(description, options, monitor, &outcome->partial);
    } catch (...) {
      outcome->partial.stem = stem;
      throw;
    }
    outcome->result.stem = stem;
    if (outcome->result.title.empty()) outcome->result.title = description.title;
    try {
      if (keep) keep(outcome->result);
    } catch (...) {
      // The result is there all the same.
    }
  });
}

void RunController::conclude(const std::exception_ptr& error) {
  const auto outcome = std::exchange(outcome_, nullptr);
  if (error) {
    const ErrorText text = errorText(error, tr("The run"));
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

}  // namespace squat::studio
