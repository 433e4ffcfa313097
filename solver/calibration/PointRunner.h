// solver/calibration/PointRunner.h - evaluates points of the search, several at once, each only once.
#pragma once

#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "calibration/EvaluationTable.h"
#include "calibration/Evaluator.h"

namespace squat::calibration {

class PointRunner {
 public:
  // Keeps references. `planned`: points that the search will take about, for the progress.
  PointRunner(EvaluationTable& table, const CalibrationDefinition& definition, const MeasuredData& data,
              const CalibrationOptions& options, std::size_t planned, Monitor& monitor);

  // From the table, or computed and put into it. Nothing where the search was cancelled or ended by an error. May be
  // called from several threads at once.
  std::optional<Evaluation> at(Stage stage, const std::string& mesh, const Values& values);

  // All of them, as many at once as there are jobs; those that are done where it was cancelled.
  std::vector<Evaluation> all(Stage stage, const std::string& mesh, const std::vector<Values>& points);

  // What this search has asked for so far, from the table or computed: a search that is repeated goes the same way,
  // whatever else the table holds. Not while points are under way.
  const std::vector<Evaluation>& seen() const { return seen_; }

  bool isCancelled();
  void rethrow();  // what ended the search, if anything did
  int jobs() const { return options_.jobs; }

 private:
  class PointMonitor;
  const Evaluator& evaluatorFor(const std::string& mesh);
  void report(const Evaluation& evaluation);

  EvaluationTable& table_;
  const CalibrationDefinition& definition_;
  const MeasuredData& data_;
  CalibrationOptions options_;
  std::size_t planned_ = 0, taken_ = 0, computed_ = 0;
  double started_ = 0;  // [s]
  double best_ = 0;     // misfit, of what is reported
  Monitor& monitor_;
  std::mutex mutex_;
  std::vector<Evaluation> seen_;
  std::map<std::string, Evaluator> evaluators_;
  std::exception_ptr error_;
};

}  // namespace squat::calibration
