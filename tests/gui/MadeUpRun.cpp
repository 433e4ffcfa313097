#include "gui/MadeUpRun.h"

#include <chrono>
#include <fstream>
#include <thread>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "render/SyntheticResult.h"

namespace squat::tests {

studio::Runner madeUpRunner(int milliseconds) {
  return [milliseconds](const cases::CaseDescription& description, const simulation::RunOptions& options,
                        Monitor& monitor, results::RunResult* partial) {
    results::RunResult result = syntheticResult();
    results::setCase(result, description);
    result.title = description.title;
    const std::size_t count = result.time.size();
    int first = 0;
    if (options.resume) std::ifstream(options.checkpointPath) >> first;
    for (int step = first; step < milliseconds; ++step) {
      while (monitor.paused()) std::this_thread::yield();
      if (monitor.cancelled()) {
        result.complete = false;
        result.stopReason = "cancelled";
        if (!options.checkpointPath.empty()) std::ofstream(options.checkpointPath) << step << '\n';
        return result;
      }
      const std::size_t at = count * static_cast<std::size_t>(step) / static_cast<std::size_t>(milliseconds);
      Progress progress;
      progress.phase = "rolling";
      progress.fraction = static_cast<double>(step) / milliseconds;
      progress.simulatedTime = result.time[at];
      progress.position = progress.accelerationPosition = result.position[at];
      progress.axleBoxAcceleration = (*result.signal("aba_filtered"))[at];
      progress.contactForce = (*result.signal("contact_force"))[at];
      progress.remainingSeconds = (milliseconds - step) * 1e-3;
      progress.elementUpdatesPerSecond = 42e6;
      if (step == first) monitor.message("begins at step " + std::to_string(first));
      monitor.report(progress);
      if (description.title == "fails" && 2 * step >= milliseconds) {
        result.complete = false;
        *partial = result;
        throw RunError("the energy grew without bound", 1234, 0.0056, "element 77 of the rail");
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return result;
  };
}

studio::StudioServices services(int milliseconds, studio::Answer answer) {
  studio::StudioServices made;
  made.runner = madeUpRunner(milliseconds);
  made.asker = [answer](QWidget*, const QString&, const QString&) { return answer; };
  return made;
}

}  // namespace squat::tests
