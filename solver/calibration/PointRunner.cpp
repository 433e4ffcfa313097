#include "calibration/PointRunner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "text/Numbers.h"

namespace squat::calibration {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

// A run under way asks only whether to stop: the search reports for all of them.
class PointRunner::PointMonitor : public Monitor {
 public:
  explicit PointMonitor(PointRunner& runner) : runner_(runner) {}
  bool cancelled() override { return runner_.isCancelled(); }
  bool paused() override {
    const std::lock_guard lock(runner_.mutex_);
    return runner_.monitor_.paused();
  }

 private:
  PointRunner& runner_;
};

PointRunner::PointRunner(EvaluationTable& table, const CalibrationDefinition& definition, const MeasuredData& data,
                         const CalibrationOptions& options, std::size_t planned, Monitor& monitor)
    : table_(table),
      definition_(definition),
      data_(data),
      options_(options),
      planned_(planned),
      started_(now()),
      best_(std::numeric_limits<double>::infinity()),
      monitor_(monitor) {}

bool PointRunner::isCancelled() {
  const std::lock_guard lock(mutex_);
  return error_ || monitor_.cancelled();
}

void PointRunner::rethrow() {
  if (error_) std::rethrow_exception(error_);
}

const Evaluator& PointRunner::evaluatorFor(const std::string& mesh) {
  const std::lock_guard lock(mutex_);
  return evaluators_.try_emplace(mesh, definition_, data_, mesh, options_).first->second;
}

// With the mutex held.
void PointRunner::report(const Evaluation& evaluation) {
  ++taken_;
  seen_.push_back(evaluation);
  if (!evaluation.hasFailed) best_ = std::min(best_, evaluation.misfit);
  Progress progress;
  progress.phase = toText(evaluation.stage) + ", " + evaluation.mesh + ", best misfit " + text::roundedText(best_);
  progress.fraction = std::min(1.0, static_cast<double>(taken_) / static_cast<double>(std::max(planned_, taken_)));
  if (computed_ > 0 && planned_ > taken_)
    progress.remainingSeconds =
        (now() - started_) / static_cast<double>(computed_) * static_cast<double>(planned_ - taken_);
  monitor_.report(progress);
}

std::optional<Evaluation> PointRunner::at(Stage stage, const std::string& mesh, const Values& values) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto* known = table_.find(mesh, values)) {
      Evaluation evaluation = *known;
      evaluation.stage = stage;
      table_.add(evaluation);  // where a part has computed it
      report(evaluation);
      return evaluation;
    }
    if (error_ || monitor_.cancelled()) return std::nullopt;
  }
  try {
    PointMonitor own(*this);
    auto evaluation = evaluatorFor(mesh).evaluate(values, own);
    if (!evaluation) return std::nullopt;
    evaluation->stage = stage;
    const std::lock_guard lock(mutex_);
    ++computed_;
    table_.add(*evaluation);
    report(*evaluation);
    return evaluation;
  } catch (...) {  // not of this point: files that cannot be written, targets in a wrong unit
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
    return std::nullopt;
  }
}

std::vector<Evaluation> PointRunner::all(Stage stage, const std::string& mesh, const std::vector<Values>& points) {
  std::vector<std::optional<Evaluation>> found(points.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < points.size(); i = next++) {
      found[i] = at(stage, mesh, points[i]);
      if (!found[i]) return;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int job = 1; job < options_.jobs; ++job) helpers.emplace_back(work);
    work();
  }
  std::vector<Evaluation> done;
  for (auto& evaluation : found)
    if (evaluation) done.push_back(std::move(*evaluation));
  return done;
}

}  // namespace squat::calibration
