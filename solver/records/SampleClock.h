// solver/records/SampleClock.h - the equal steps behind a column of times: their length, and which row keeps them.
#pragma once

#include <cstddef>
#include <vector>

namespace squat::records {

struct ClockSteps {
  double step = 0;            // [s] between samples; 0: not to be found
  double resolution = 0;      // [s] by which a time as it is written may be off
  double accuracy = 0;        // of the step, relative
  bool losesSamples = false;  // again and again (LostSamples.h)
};

// From the first times of a record. Times that are rounded, repeated or written in batches are understood; up to one
// step in ten thousand (at least two) may be a gap.
ClockSteps stepsOf(const std::vector<double>& times);

// Follows the times of a record: rounding averages out, and a slow drift is no change of rate. Steps are counted and
// multiplied: added one by one to a time since 1970, each step would lose its last digits.
class SampleClock {
 public:
  explicit SampleClock(const ClockSteps& steps) : steps_(steps) {}

  void start(double time) { start_ = time, rows_ = 0, slip_ = 0; }
  // How far the time of the next row is from where it should be. [s]
  double deviation(double time) const { return (time - start_) - ((rows_ + 1) * steps_.step + slip_); }
  bool keeps(double deviation) const;
  void follow(double deviation) { rows_ += 1, slip_ += deviation / averaging; }
  void skip() { rows_ += 1; }                                            // a row without a time
  double now() const { return start_ + (rows_ * steps_.step + slip_); }  // [s] of the last row

  // Rows that tell a gap from another rate, and whether they do.
  std::size_t window() const;
  bool fits(double step) const;  // between two rows
  bool sameRate(const double* times, std::size_t count) const;
  double step() const { return steps_.step; }

 private:
  static constexpr double averaging = 1024;  // [samples]
  ClockSteps steps_;
  double start_ = 0, slip_ = 0;  // [s] where the steps are counted from; what they drift from equal ones
  double rows_ = 0;              // since the start
};

}  // namespace squat::records
