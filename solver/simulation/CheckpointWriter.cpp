#include "simulation/CheckpointWriter.h"

#include <utility>

#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "simulation/DivergenceGuard.h"
#include "simulation/FieldRecorder.h"
#include "simulation/RollingStateFile.h"

namespace squat::simulation {

CheckpointWriter::CheckpointWriter(CheckpointOptions options, const RunStart& start, const Observers& observers,
                                   const results::RunResult& result, const RunClock& clock,
                                   std::function<void(const std::string&)> warn)
    : options_(std::move(options)),
      start_(start),
      observers_(observers),
      result_(result),
      clock_(clock),
      warn_(std::move(warn)) {}

results::ArrayTree stateOf(const dynamics::Rolling& rolling, const RunStart& start, const Observers& observers,
                           const results::RunResult& result) {
  DivergenceGuard::checkEverything(rolling);
  results::ArrayTree tree;
  setAttribute(tree.attributes, "case_hash", result.caseHash);
  setAttribute(tree.attributes, "code_version", result.codeVersion);
  setAttribute(tree.attributes, "isa", result.isa);
  saveRolling(rolling, tree);
  for (const auto* observer : observers) observer->save(tree);
  saveStart(start, result, tree);
  savePictures(result, tree);
  return tree;
}

void CheckpointWriter::onStep(const dynamics::Rolling& rolling) {
  if (clock_.seconds() - lastWritten_ > options_.seconds) write(rolling);
}

void CheckpointWriter::write(const dynamics::Rolling& rolling) {
  if (options_.path.empty()) return;
  auto tree = stateOf(rolling, start_, observers_, result_);
  try {
    results::writeCheckpoint(options_.path, std::move(tree));
  } catch (const FileError& error) {
    if (!std::exchange(hasWarned_, true))
      warn_(std::string("the run continues without this checkpoint: ") + error.what());
  }
  lastWritten_ = clock_.seconds();
}

}  // namespace squat::simulation
