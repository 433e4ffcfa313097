#include "gui/PreviewSolvers.h"

#include <chrono>
#include <thread>

#include "core/Errors.h"
#include "render/SyntheticResult.h"

namespace squat::tests {
namespace {

using cases::CaseDescription;
using simulation::RunOptions;
using simulation::WarmState;

// True unless it was cancelled.
bool passTime(int milliseconds, Monitor& monitor, const char* phase) {
  for (int step = 0; step < milliseconds; ++step) {
    if (monitor.cancelled()) return false;
    Progress progress;
    progress.phase = phase;
    progress.fraction = static_cast<double>(step) / milliseconds;
    monitor.report(progress);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return !monitor.cancelled();
}

results::RunResult madeUpPreview(const CaseDescription& description, const RunOptions& options, Monitor& monitor,
                                 int milliseconds) {
  auto result = syntheticResult();
  results::setCase(result, description);
  const auto& acceleration = *result.signal("aba_filtered");
  const std::size_t count = result.time.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (options.sampled) options.sampled(result.position[i], acceleration[i]);
    if (i * static_cast<std::size_t>(milliseconds) / count == (i + 1) * static_cast<std::size_t>(milliseconds) / count)
      continue;
    if (description.title == "fails" && 2 * i > count) throw RunError("made to fail", 1, 0, "nowhere");
    if (!passTime(1, monitor, "rolling")) {
      result.complete = false;
      return result;
    }
  }
  return result;
}

}  // namespace

studio::PreviewSolver realPreviewSolver() {
  return {simulation::makeWarmState, simulation::rollOn, simulation::runCase};
}

studio::PreviewSolver madeUpPreviewSolver(const std::shared_ptr<PreviewCalls>& calls, int startMilliseconds,
                                          int runMilliseconds) {
  studio::PreviewSolver solver;
  solver.makeStart = [=](const CaseDescription& description, const RunOptions&,
                         Monitor& monitor) -> std::optional<WarmState> {
    ++calls->started;
    if (!passTime(startMilliseconds, monitor, "equilibrium")) return std::nullopt;
    ++calls->made;
    WarmState state;
    state.description = description;
    return state;
  };
  solver.rollOn = [=](const std::shared_ptr<const WarmState>& from, const CaseDescription&, double, const RunOptions&,
                      Monitor& monitor) -> std::optional<WarmState> {
    if (monitor.cancelled()) return std::nullopt;
    ++calls->rolledOn;
    return *from;
  };
  solver.run = [=](const CaseDescription& description, const RunOptions& options, Monitor& monitor,
                   results::RunResult*) {
    ++calls->begun;
    auto result = madeUpPreview(description, options, monitor, runMilliseconds);
    ++(result.complete ? calls->complete : calls->cancelled);
    return result;
  };
  return solver;
}

}  // namespace squat::tests
