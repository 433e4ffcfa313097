#include "records/TrackPosition.h"

#include <algorithm>
#include <cmath>

namespace squat::records {
namespace {

constexpr double tolerance = 1;  // [m] that a counter or a fix may be off without being wrong

}  // namespace

void TrackPosition::knot(const WorkRows& rows, std::size_t row, double time) {
  change_ = rows.first + row;
  value_ = rows.position[row];
  time_ = time;
}

// `rise` a sample behind row `from`.
void TrackPosition::spread(WorkRows& rows, std::size_t from, std::size_t to, double rise) const {
  const double start = rows.position[from];
  for (std::size_t i = from + 1; i < to; ++i) rows.position[i] = start + rise * static_cast<double>(i - from);
}

void TrackPosition::finish(WorkRows& rows, std::size_t row) {
  const std::size_t from = std::max(change_, released_ > 0 ? released_ - 1 : 0);
  if (!started_ || interval_ == 0 || back_ || from < rows.first || rows.first + row - change_ > 2 * interval_) return;
  spread(rows, from - rows.first, row, rise_ / static_cast<double>(interval_));
}

Advance TrackPosition::check(WorkRows& rows, std::size_t row, double time, bool starts) {
  double& x = rows.position[row];
  const bool known = std::isfinite(x);
  if (back_) {
    if (known) low_ = std::min(low_, x);
    if (!known || x < low_ + 2 * tolerance) return Advance::stillBack;
    back_ = false;
    starts = true;
  }
  if (!known) x = value_;
  if (starts || !started_) {
    finish(rows, row);
    started_ = true;
    interval_ = 0;
    knot(rows, row, time);
    return Advance::goesOn;
  }
  if (x < value_ - tolerance) {
    finish(rows, row);
    back_ = true;
    low_ = x;
    return Advance::goesBack;
  }
  if (x <= value_) {
    x = value_;
    return Advance::goesOn;
  }
  if (x - value_ > tolerance + fastest_ * (time - time_)) {
    finish(rows, row);
    interval_ = 0;
    knot(rows, row, time);
    return Advance::jumps;
  }
  const std::size_t here = rows.first + row, from = std::max(change_, released_ > 0 ? released_ - 1 : 0);
  interval_ = here - change_;
  rise_ = x - value_;
  if (from >= rows.first && here > from + 1)
    spread(rows, from - rows.first, row, (x - rows.position[from - rows.first]) / static_cast<double>(here - from));
  knot(rows, row, time);
  return Advance::goesOn;
}

}  // namespace squat::records
