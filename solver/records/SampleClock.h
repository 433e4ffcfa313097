// solver/records/SampleClock.h - the equal steps behind a column of times: their length, and which row keeps them.
#pragma once

#include <cstddef>
#include <vector>

namespace squat::records {

struct ClockSteps {
  double step = 0;        // [s] between samples; 0: not to be found
  double resolution = 0;  // [s] by which a time as it is written may be off
  double accuracy = 0;    // of the step, relative
};

// From the first times of a record. Times that are rounded, repeated or written in batches are understood; up to one
// step in ten thousand (at least two) may be a gap.
ClockSteps stepsOf(const std::vector<double>& times);

// Follows the times of a record: rounding averages out, and a slow drift is no change of rate.
class SampleClock {
 public:
  explicit SampleClock(const ClockSteps& steps) : steps_(steps) {}

  void start(double time) { now_ = time; }
  // How far the time of the next row is from where it should be. [s]
  double deviation(double time) const { return time - (now_ + steps_.step); }
  bool keeps(double deviation) const;
  void follow(double deviation) { now_ += steps_.step + deviation / averaging; }
  void skip() { now_ += steps_.step; }  // a row without a time
  double now() const { return now_; }   // [s] of the last row

  // Rows that tell a gap from another rate, and whether they do.
  std::size_t window() const;
  bool fits(double step) const;  // between two rows
  bool sameRate(const double* times, std::size_t count) const;
  double step() const { return steps_.step; }

 private:
  static constexpr double averaging = 1024;  // [samples]
  ClockSteps steps_;
  double now_ = 0;
};

}  // namespace squat::records
