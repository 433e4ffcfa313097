// solver/calibration/EvaluationTable.h - every point of a search, on disk as soon as it is known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/Calibration.h"

namespace squat::calibration {

// FOLDER/calibration.csv: stage, mesh, state, misfit, the inputs, the value of each target, message. The residuals of
// each point are in calibration-residuals.csv, calibration.json says which calibration it is. Not safe to be used by
// several threads at once.
class EvaluationTable {
 public:
  // Takes what the folder holds of the same calibration. Throws CaseError where it holds another one, FileError where
  // its files are damaged.
  EvaluationTable(const CalibrationDefinition& definition, std::string folder);

  // Makes the points that parts have computed (FOLDER/parts) known. Throws as the constructor does.
  void takeParts();

  const std::vector<Evaluation>& rows() const { return rows_; }
  // Null: not evaluated yet.
  const Evaluation* find(const std::string& mesh, const Values& values) const;
  // Adds the point where it is none of the rows yet, and writes the files.
  void add(Evaluation evaluation);

 private:
  void requireSame(const std::string& folder) const;
  std::vector<Evaluation> read(const std::string& folder) const;
  void write() const;

  const CalibrationDefinition& definition_;
  std::string folder_;
  std::vector<Evaluation> rows_;
  std::vector<Evaluation> ofParts_;  // known, and no rows until the search comes to them
};

}  // namespace squat::calibration
