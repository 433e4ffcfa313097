// solver/records/RowChecks.h - which rows of a record belong together, and why others do not.
#pragma once

#include <optional>
#include <string>

#include "records/FaultList.h"
#include "records/RecordStream.h"
#include "records/SampleClock.h"
#include "records/TrackPosition.h"
#include "records/WorkRows.h"

namespace squat::records {

// How the rows are judged.
struct RowRules {
  ClockSteps steps;
  bool positions = false;  // a column of the file; else they come from the speed
  double start = 0;        // [m] of the first sample, where they come from the speed
  double speed = 0;        // [m/s] constant; 0: from its column, or from the positions
  double direction = 1;    // -1: the chainage falls along the run
};

class RowChecks {
 public:
  RowChecks(const RowRules& rules, FaultList& faults) : rules_(rules), faults_(faults), clock_(rules.steps) {}

  // Marks the rows that have come, puts the smoothed time into `time` and the position into `position` (rising). The
  // last rows may stay without a mark until more have come, or the file has `ended`.
  void check(WorkRows& rows, bool ended);
  std::size_t settled() const;  // sample before which positions are final
  void release(std::size_t sample) { track_.release(sample); }

 private:
  bool isBad(const WorkRows& rows, std::size_t row) const;
  bool checkClock(WorkRows& rows, std::size_t row, bool ended, bool fresh, Mark& mark);
  void checkPosition(WorkRows& rows, std::size_t row, Mark& mark);
  void endOtherRate(const WorkRows& rows, std::size_t row, bool ended);
  double timeAt(const WorkRows& rows, std::size_t row) const;
  void reportBreak(const WorkRows& rows, std::size_t row, double deviation);
  std::size_t report(const WorkRows& rows, std::size_t row, FaultKind kind, std::size_t length, std::string text,
                     std::string advice);

  RowRules rules_;
  FaultList& faults_;
  SampleClock clock_;
  TrackPosition track_;
  bool started_ = false, broken_ = true;  // the row before was bad
  std::size_t otherRateUntil_ = 0;        // rows before this sample have another rate
  bool otherRate_ = false;
  std::size_t openFault_ = 0;  // index of the fault that goes on
  double run_ = 0, travelled_ = 0, lastTime_ = 0;
};

}  // namespace squat::records
