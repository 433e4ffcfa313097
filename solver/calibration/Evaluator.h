// solver/calibration/Evaluator.h - what one point of the search gives on one mesh.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "calibration/Calibration.h"
#include "calibration/DecayResiduals.h"
#include "calibration/ReceptanceResiduals.h"
#include "calibration/SignalResiduals.h"
#include "studies/SharedStart.h"

namespace squat::calibration {

// Measured data, read once for all points.
struct MeasuredData {
  std::vector<MeasuredSignal> signals;
  std::vector<MeasuredReceptance> receptances;
  std::vector<MeasuredDecays> decays;
};
MeasuredData readMeasuredData(const Targets& targets);

// Where only the defect is free, all points start from one warm state (studies/SharedStart.h).
class Evaluator {
 public:
  // Keeps references to definition and data. `mesh` is a preset.
  Evaluator(const CalibrationDefinition& definition, const MeasuredData& data, std::string mesh,
            const CalibrationOptions& options);

  // May be called from several threads at once. Nothing where it was cancelled. A case that cannot be run and a run
  // that fails are failed evaluations. At the first point throws FileError for measured receptance in another unit.
  std::optional<Evaluation> evaluate(const Values& values, Monitor& monitor) const;

 private:
  struct Run {
    cases::CaseOverrides overrides;
    studies::StudyDefinition definition;
    std::unique_ptr<studies::SharedStart> start;
  };
  bool isUsed(const std::string& run) const;
  cases::CaseDescription caseOf(const Run& run, const Values& values) const;
  bool computeReceptances(const Values& values, std::vector<TargetValue>& targets, Monitor& monitor) const;
  bool computeDecays(const Values& values, std::vector<TargetValue>& targets, Monitor& monitor) const;

  const CalibrationDefinition& definition_;
  const MeasuredData& data_;
  std::string mesh_;
  CalibrationOptions options_;
  std::map<std::string, Run> runs_;
  // The case on its own mesh, for the receptance, which has a mesh of its own: the track of `tiny` is too short for it.
  Run own_;
};

// The weighted mean over the targets.
double totalMisfit(const Targets& targets, const std::vector<TargetValue>& values);

}  // namespace squat::calibration
