#include "records/RowChecks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/Numbers.h"

namespace squat::records {
namespace {

std::string milliseconds(double seconds) { return text::roundedText(1000 * seconds) + " ms"; }

}  // namespace

double RowChecks::timeAt(const WorkRows& rows, std::size_t row) const {
  return rows.time.empty() ? static_cast<double>(rows.first + row) * rules_.steps.step : rows.time[row];
}

std::size_t RowChecks::settled() const { return rules_.positions ? track_.settled() : static_cast<std::size_t>(-1); }

std::size_t RowChecks::report(const WorkRows& rows, std::size_t row, FaultKind kind, std::size_t length,
                              std::string text, std::string advice) {
  RecordFault fault;
  fault.kind = kind;
  fault.first = rows.first + row;
  fault.end = fault.first + length;
  fault.time = std::isfinite(timeAt(rows, row)) ? timeAt(rows, row) : clock_.now();
  fault.position = !rules_.positions                   ? travelled_
                   : std::isfinite(rows.position[row]) ? rows.position[row]
                                                       : track_.last();
  fault.position *= rules_.direction;
  fault.text =
      (rows.lines.empty() ? "sample " + std::to_string(fault.first + 1) : "line " + std::to_string(rows.lines[row])) +
      ": " + std::move(text);
  fault.advice = std::move(advice);
  return faults_.add(std::move(fault));
}

// No time, or no channel that has a number.
bool RowChecks::isBad(const WorkRows& rows, std::size_t row) const {
  if (!rows.time.empty() && !std::isfinite(rows.time[row])) return true;
  if (rules_.positions && !started_ && !std::isfinite(rows.position[row])) return true;
  return std::none_of(rows.channels.begin(), rows.channels.end(),
                      [row](const auto& channel) { return std::isfinite(channel[row]); });
}

// The rows before `row` have another rate: looks how far that goes on.
void RowChecks::endOtherRate(const WorkRows& rows, std::size_t row, bool ended) {
  const std::size_t window = clock_.window();
  if (row + window > rows.size()) {
    otherRateUntil_ = ended ? rows.first + rows.size() : rows.first + row;
    return;
  }
  const double* times = rows.time.data() + row;
  std::size_t bad = window / 2;
  if (clock_.sameRate(times, window)) {  // most steps of the window are right again: from the first of them on
    bad = 0;
    while (bad + 2 < window && !clock_.fits(times[bad + 1] - times[bad])) ++bad;
  }
  otherRateUntil_ = rows.first + row + bad;
}

void RowChecks::reportBreak(const WorkRows& rows, std::size_t row, double deviation) {
  const bool stands = deviation > -1.5 * clock_.step() - rules_.steps.resolution;
  report(rows, row, FaultKind::gap, 0,
         deviation > 0 ? "a gap of " + milliseconds(deviation) + " before this sample"
         : stands      ? std::string("the time does not advance")
                       : "the time goes back by " + milliseconds(-deviation),
         "Nothing to do: the parts before and behind it are read as two stretches");
}

// `fresh`: nothing is known of its time. False: more rows are needed first.
bool RowChecks::checkClock(WorkRows& rows, std::size_t row, bool ended, bool fresh, Mark& mark) {
  if (rows.time.empty()) return true;
  const double time = rows.time[row], deviation = clock_.deviation(time);
  const std::size_t window = clock_.window(), here = rows.first + row;
  const bool enough = ended || row + window <= rows.size();
  if (otherRate_) {
    if (here >= otherRateUntil_ && !enough) return false;
    if (here >= otherRateUntil_) endOtherRate(rows, row, ended);
    if (here < otherRateUntil_) {
      faults_.extend(openFault_, here + 1);
      mark = Mark::bad;
      return true;
    }
    otherRate_ = false;
    mark = Mark::starts;
    clock_.start(time);
  } else if (fresh) {
    clock_.start(time);
  } else if (clock_.keeps(deviation)) {
    clock_.follow(deviation);
  } else {
    if (!enough) return false;
    const std::size_t count = std::min(window, rows.size() - row);
    if (!clock_.sameRate(rows.time.data() + row, count)) {
      openFault_ = report(rows, row, FaultKind::rateChange, 1,
                          "the time step changes; it is " + milliseconds(clock_.step()) + " at the beginning",
                          "Give the part with the other rate as a record of its own");
      otherRate_ = true;
      otherRateUntil_ = here + count / 2;
      mark = Mark::bad;
      return true;
    }
    reportBreak(rows, row, deviation);
    clock_.start(time);
    mark = Mark::starts;
  }
  rows.time[row] = clock_.now();
  return true;
}

void RowChecks::checkPosition(WorkRows& rows, std::size_t row, Mark& mark) {
  const double time = timeAt(rows, row);
  if (!rules_.positions) {
    const double speed = rows.speed.empty() ? rules_.speed : rows.speed[row];
    if (!started_) travelled_ = rules_.start * rules_.direction;
    if (started_) travelled_ += speed * std::max(0.0, time - lastTime_);
    lastTime_ = time;
    rows.position[row] = travelled_;
    return;
  }
  const double before = track_.last(), here = rows.position[row];
  switch (track_.check(rows, row, time, mark == Mark::starts)) {
    case Advance::goesOn:
      break;
    case Advance::jumps:
      mark = Mark::starts;
      report(rows, row, FaultKind::positionJump, 0, "the position jumps by " + text::roundedText(here - before) + " m",
             "Check the counter: the parts before and behind it are read as two stretches");
      break;
    case Advance::goesBack:
      mark = Mark::bad;
      openFault_ = report(
          rows, row, FaultKind::positionJump, 1, "the position goes back by " + text::roundedText(before - here) + " m",
          "Remove reversing, or check the counter; what follows is read once the position advances again");
      break;
    case Advance::stillBack:
      mark = Mark::bad;
      faults_.extend(openFault_, rows.first + row + 1);
      break;
  }
}

void RowChecks::check(WorkRows& rows, bool ended) {
  if (!rules_.positions) rows.position.resize(rows.size());
  for (std::size_t row = rows.marks.size(); row < rows.size(); ++row) {
    if (isBad(rows, row)) {
      report(rows, row, FaultKind::notANumber, 1, "no number in this row",
             "Nothing to do: the parts before and behind it are read as two stretches");
      clock_.skip();
      broken_ = true;
      rows.marks.push_back(Mark::bad);
      continue;
    }
    const bool otherRun = !rows.run.empty() && started_ && rows.run[row] != run_;
    Mark mark = broken_ || otherRun ? Mark::starts : Mark::follows;
    if (!checkClock(rows, row, ended, !started_ || otherRun, mark)) return;
    if (mark != Mark::bad) checkPosition(rows, row, mark);
    if (!rows.run.empty()) run_ = rows.run[row];
    started_ = started_ || mark != Mark::bad;
    broken_ = mark == Mark::bad;
    rows.marks.push_back(mark);
  }
  if (ended && rules_.positions) track_.finish(rows, rows.size());
}

}  // namespace squat::records
