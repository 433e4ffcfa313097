// solver/simulation/FieldRecorder.h - pictures of surface fields and contact patch while the wheel passes the defect.
#pragma once

#include "results/RunResult.h"
#include "simulation/ModelFields.h"
#include "simulation/StepObserver.h"

namespace squat::simulation {

// Takes "impact" where the wheel reaches the deepest point, and twelve frames about it.
class FieldRecorder : public StepObserver {
 public:
  // Looks at every `grid`-th step of a sample of `perSample` steps: at the same ones however often the run was stopped.
  // Snapshots and patches go to `result`.
  FieldRecorder(const ModelFields& fields, results::RunResult& result, long perSample, long grid)
      : fields_(fields), result_(result), perSample_(perSample), grid_(grid) {}

  long nextStep(long done) const override;
  void onStep(const dynamics::Rolling& rolling) override;

 private:
  bool has(const std::string& name) const;
  void take(const std::string& name, const dynamics::Rolling& rolling);

  const ModelFields& fields_;
  results::RunResult& result_;
  long perSample_, grid_;
};

// Pressure and traction at the integration points of the present patch of one side.
results::PatchSnapshot patchSnapshot(const std::string& name, const dynamics::Rolling& rolling);

// Snapshots and patches of a result in a checkpoint; those of the start are there too where nobody takes others.
// Loading throws FileError where an array is missing or of a wrong type.
void savePictures(const results::RunResult& result, results::ArrayTree& tree);
void loadPictures(const results::ArrayTree& tree, const std::string& file, results::RunResult& result);

}  // namespace squat::simulation
