// solver/records/TrackPosition.h - the position of every sample, from a column that may be coarse or jump.
#pragma once

#include <cstddef>

#include "records/WorkRows.h"

namespace squat::records {

enum class Advance { goesOn, jumps, goesBack, stillBack };

// Works on `rows.position`, turned so that it rises along the run. Repeated values (a coarse encoder, a fix each
// second) are spread evenly as soon as the next one is there: rows behind `settled` may still change.
class TrackPosition {
 public:
  explicit TrackPosition(double fastest = 150) : fastest_(fastest) {}

  // The next row; `starts`: a new stretch begins there for another reason. Rows without a number repeat the last one.
  Advance check(WorkRows& rows, std::size_t row, double time, bool starts);
  // The stretch is over at `row`: what was repeated at its end goes on as before.
  void finish(WorkRows& rows, std::size_t row);
  // Rows before this sample are final; those before `released` are not touched any more.
  std::size_t settled() const { return change_ + 1; }
  void release(std::size_t sample) { released_ = sample; }
  double last() const { return value_; }

 private:
  void knot(const WorkRows& rows, std::size_t row, double time);
  void spread(WorkRows& rows, std::size_t from, std::size_t to, double rise) const;

  double fastest_;  // [m/s] a step of the position faster than this is a jump
  bool started_ = false, back_ = false;
  std::size_t change_ = 0;    // sample of the last new value
  std::size_t interval_ = 0;  // samples between the last two
  std::size_t released_ = 0;
  double value_ = 0, time_ = 0, rise_ = 0, low_ = 0;
};

}  // namespace squat::records
