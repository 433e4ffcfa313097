#include "records/RecordReader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Errors.h"
#include "readers/TableRoles.h"
#include "records/LostSamples.h"
#include "signals/Median.h"
#include "text/Numbers.h"

namespace squat::records {
namespace {

constexpr double speedWindow = 0.25;  // [s] to both sides, over which positions become a speed
constexpr double largest = 1e100;     // squares of values stay within the range of double

double medianStep(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (std::isfinite(values[i] - values[i - 1])) steps.push_back(std::abs(values[i] - values[i - 1]));
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

// Last finite value minus first; 0 where there are none.
double changeOf(const std::vector<double>& values) {
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto first = std::find_if(values.begin(), values.end(), finite);
  const auto last = std::find_if(values.rbegin(), values.rend(), finite);
  return first == values.end() ? 0 : *last - *first;
}

double nearWhole(double rate, double accuracy) {
  return std::abs(rate - std::round(rate)) <= accuracy * rate ? std::round(rate) : rate;
}

// Straight lines between fixes that are repeated, or missing, until the next one comes.
void spreadRepeats(std::vector<double>& values, double before) {
  std::size_t anchor = 0;
  if (!values.empty() && !std::isfinite(values[0])) values[0] = before;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) values[i] = values[i - 1];
    if (values[i] == values[anchor] || values[i] == values[i - 1]) continue;
    const double from = values[anchor], rise = (values[i] - from) / static_cast<double>(i - anchor);
    for (std::size_t k = anchor + 1; k < i; ++k) values[k] = from + rise * static_cast<double>(k - anchor);
    anchor = i;
  }
}

}  // namespace

RecordReader::RecordReader(std::string path, std::unique_ptr<RowSource> source, const RecordOptions& options)
    : options_(options), source_(std::move(source)) {
  layout_.path = std::move(path);
  options_.blockLength = std::max<std::size_t>(options_.blockLength, 1);
  if (options_.columns.rate == 0) options_.columns.rate = source_->rate;
  if (options_.columns.speed == 0) options_.columns.speed = source_->speed;
  if (!source_->signalColumn.empty()) options_.columns.column = source_->signalColumn;
  text::DelimitedTable head = source_->head();
  readers::setUnits(head, options_.columns);
  chosen_ = chooseColumns(head, options_.columns, options_.everyAcceleration);
  layout_.notes = source_->notes;
  layout_.notes.insert(layout_.notes.end(), chosen_.notes.begin(), chosen_.notes.end());
  for (const auto& channel : chosen_.channels) layout_.channels.push_back({channel.name, channel.unit});
  layout_.hasCoordinates = !chosen_.latitude.empty();
  std::vector<std::size_t> columns;
  for (const auto* group : {&chosen_.channels, &chosen_.time, &chosen_.position, &chosen_.speed, &chosen_.run,
                            &chosen_.latitude, &chosen_.longitude})
    for (const auto& column : *group) columns.push_back(column.column);
  source_->choose(std::move(columns));
  work_.channels.resize(chosen_.channels.size());
  lastGood_.assign(chosen_.channels.size(), 0.0);
  fetch();
  layout_.samples = source_->rows();
  layout_.hasPosition = !chosen_.position.empty();
  if (work_.size() < 2)
    throw FileError(layout_.path, "", "has " + std::to_string(work_.size()) + " samples; at least 2 are needed");
  const RowRules rules = findRules();
  if (rules.steps.losesSamples && timesUsed_ && !work_.time.empty()) {
    lostStep_ = rules.steps.step;
    bridged_ += bridgeLostSamples(work_, 1, lostStep_);
  }
  layout_.falling = rules.direction < 0;
  direction_ = rules.direction;
  for (double& x : work_.position) x *= direction_;
  judgeSpeed();
  judgeValues();
  judgeCoordinates();
  checks_ = std::make_unique<RowChecks>(rules, faults_);
  check(0);
}

RowRules RecordReader::findRules() {
  RowRules rules;
  const auto& options = options_.columns;
  rules.speed = options.speed;
  rules.start = options_.chainage.value_or(0);
  rules.positions = layout_.hasPosition;
  if (rules.positions && changeOf(work_.position) < 0) rules.direction = -1;
  if (!rules.positions && chosen_.speed.empty() && !(rules.speed > 0))
    throw CaseError({{"--speed", "none", "a positive number in m/s",
                      layout_.path + " has neither a position nor a speed column: give the speed"}});
  if (!work_.time.empty()) rules.steps = stepsOf(work_.time);
  const double fromTime = rules.steps.step > 0 ? nearWhole(1 / rules.steps.step, rules.steps.accuracy) : 0;
  if (options.rate > 0) {
    layout_.rate = options.rate;
    if (!work_.time.empty() && std::abs(fromTime / options.rate - 1) > 0.01 + rules.steps.accuracy) {
      layout_.notes.push_back("the times say " + text::roundedText(fromTime) + " Hz; the rate given, " +
                              text::roundedText(options.rate) + " Hz, is used, and the times are not");
      work_.time.clear();
      timesUsed_ = false;
    }
  } else if (fromTime > 0) {
    layout_.rate = fromTime;
  } else if (!work_.time.empty()) {
    throw FileError(layout_.path, "column " + std::to_string(chosen_.time[0].column + 1),
                    "'" + chosen_.time[0].name + "' does not rise as a time does",
                    "Name the time column, or give the rate; time and position may be swapped");
  } else if (rules.positions && rules.speed > 0 && medianStep(work_.position) > 0) {
    layout_.rate = rules.speed / medianStep(work_.position);
    layout_.notes.push_back("the rate comes from equal steps of the position and the speed given");
  } else {
    throw FileError(layout_.path, "", "has no time column that is known as one, so the sampling rate is not known",
                    "Give the rate, or name the time column");
  }
  const bool guessed = !work_.time.empty() && fromTime > 0 && !chosen_.time[0].unitStated;
  constexpr double slowest = 1000, quickest = 1e6;  // [Hz] between which only seconds make sense of an unstated unit
  if (guessed && (fromTime < slowest || fromTime > quickest))
    throw FileError(layout_.path, "column " + std::to_string(chosen_.time[0].column + 1),
                    "'" + chosen_.time[0].name + "' states no unit; in seconds, the record would be sampled at " +
                        text::roundedText(fromTime) + " Hz",
                    "Give its unit with --time-unit: s, ms, us, ns or min");
  if (guessed)
    layout_.notes.push_back("'" + chosen_.time[0].name +
                            "' states no unit: seconds are assumed, which is sampling at " +
                            text::roundedText(fromTime) + " Hz");
  constexpr double fastest = 1e7;  // [Hz]: beyond it the unit of the time is wrong
  if (!(layout_.rate <= fastest) || !(layout_.rate >= 1))
    throw FileError(layout_.path, "", "is sampled at " + text::roundedText(layout_.rate) + " Hz",
                    "1 to 1e7 Hz are read; check the unit of time, and whether time and position are swapped");
  rules.steps.step = 1 / layout_.rate;
  return rules;
}

// Positions, times and speeds of one train: a unit that is wrong by a factor shows here.
void RecordReader::judgeSpeed() {
  if (work_.time.empty() || work_.size() < 2) return;
  const double duration = changeOf(work_.time);
  constexpr double shortest = 0.2, fastest = 150;  // [s], [m/s]
  if (!(duration > shortest)) return;
  double sum = 0, count = 0;
  for (const double speed : work_.speed)
    if (std::isfinite(speed)) sum += speed, count += 1;
  const double stated = count > 0 ? sum / count : 0;
  const double moved = work_.position.empty() ? 0 : std::abs(changeOf(work_.position)) / duration;
  const auto columnOf = [](const ChosenColumn& column) { return "column " + std::to_string(column.column + 1); };
  const auto perSecond = [](double speed) { return text::roundedText(speed) + " m/s"; };
  if (stated > fastest)
    throw FileError(
        layout_.path, columnOf(chosen_.speed[0]),
        "'" + chosen_.speed[0].name + "' is " + perSecond(stated) + " on the average; a train has at most 150 m/s",
        "Give its unit: --unit " + chosen_.speed[0].name + "=km/h, say");
  if (layout_.hasPosition && moved > fastest)
    throw FileError(layout_.path, columnOf(chosen_.position[0]),
                    "'" + chosen_.position[0].name + "' moves at " + perSecond(moved) +
                        " by the times; a train has at most 150 m/s",
                    "Give the units: --unit " + chosen_.position[0].name + "=mm, say, or --time-unit");
  constexpr double leastSpeed = 1, leastWay = 5, alike = 0.1;  // [m/s], [m], relative
  if (!layout_.hasPosition || !(stated > leastSpeed) || !(moved * duration > leastWay)) return;
  if (std::abs(moved / stated - 1) > alike)
    throw FileError(layout_.path, columnOf(chosen_.speed[0]),
                    "'" + chosen_.speed[0].name + "' is " + perSecond(stated) + " on the average, where '" +
                        chosen_.position[0].name + "' moves at " + perSecond(moved) + " by the times",
                    "Give the unit of the one that is wrong: --unit COLUMN=UNIT, or --time-unit");
}

// Notes and doubts about units, from the first rows.
void RecordReader::judgeValues() {
  for (std::size_t c = 0; c < work_.channels.size(); ++c) {
    const auto& column = chosen_.channels[c];
    double sum = 0, squares = 0, count = 0;
    for (const double value : work_.channels[c])
      if (std::isfinite(value)) {
        sum += value;
        squares += value * value;
        count += 1;
      }
    if (count < 100 || column.unit != "m/s2") continue;
    const double mean = sum / count, rms = std::sqrt(squares / count);
    // The mean of a short signal, such as one passage, is too uncertain to show gravity.
    const double deviation = std::sqrt(std::max(0.0, rms * rms - mean * mean));
    const bool meanIsKnown = deviation / std::sqrt(count) < 0.05 * column.factor;
    const auto note = [&](const std::string& what) {
      layout_.notes.push_back("'" + column.name + "' " + what + ": check its unit");
    };
    if (meanIsKnown && column.factor == 1 && std::abs(std::abs(mean) - 1) < 0.05)
      note("has a mean of " + text::roundedText(mean) + " m/s2, as gravity has in g");
    else if (meanIsKnown && column.factor > 9 && std::abs(std::abs(mean) / column.factor - 9.81) < 0.3)
      note("has a mean of " + text::roundedText(mean / column.factor) + " g, as gravity has in m/s2");
    else if (column.factor == 1 && rms > 0 && rms < 2)
      note("has an rms of " + text::roundedText(rms) + " m/s2, little for an axle box; it may be in g");
    else if (rms > 5000)
      note("has an rms of " + text::roundedText(rms) + " m/s2, much for an axle box");
  }
}

// Coordinates that cannot be are left out, not guessed.
void RecordReader::judgeCoordinates() {
  if (!layout_.hasCoordinates) return;
  const auto beyond = [](const std::vector<double>& values, double maximum) {
    return std::find_if(values.begin(), values.end(), [maximum](double v) { return std::abs(v) > maximum; });
  };
  const auto north = beyond(work_.latitude, 90), east = beyond(work_.longitude, 180);
  if (north == work_.latitude.end() && east == work_.longitude.end()) return;
  const bool swapped = beyond(work_.longitude, 90) == work_.longitude.end();
  const auto row = static_cast<std::size_t>(north != work_.latitude.end() ? north - work_.latitude.begin()
                                                                          : east - work_.longitude.begin());
  faults_.add({FaultKind::unit, row, row, static_cast<double>(row) / layout_.rate, 0, -1,
               north != work_.latitude.end() ? "a latitude of " + text::roundedText(*north) + " degrees"
                                             : "a longitude of " + text::roundedText(*east) + " degrees",
               swapped ? "Latitude and longitude are swapped, it seems: the coordinates are left out"
                       : "Coordinates are in degrees; these are left out"});
  layout_.hasCoordinates = false;
}

void RecordReader::reportChannel(std::size_t channel, std::size_t row, std::size_t end) {
  RecordFault fault;
  fault.kind = FaultKind::notANumber;
  fault.first = work_.first + row;
  fault.end = work_.first + end;
  fault.time = work_.time.empty() ? static_cast<double>(fault.first) / layout_.rate : work_.time[row];
  fault.position = work_.position.size() > row ? work_.position[row] * direction_ : 0;
  fault.channel = static_cast<int>(channel);
  fault.text = "'" + chosen_.channels[channel].name + "' has no number here";
  fault.advice = "Nothing to do: the other channels are read on; this one is a straight line there";
  faults_.add(std::move(fault));
}

// A channel that lacks a number while others have theirs: a straight line, and a fault of that channel.
void RecordReader::fillChannel(std::size_t channel, std::size_t from) {
  auto& values = work_.channels[channel];
  const auto alone = [&](std::size_t row) {
    return std::none_of(work_.channels.begin(), work_.channels.end(),
                        [row](const auto& other) { return std::isfinite(other[row]); });
  };
  for (std::size_t row = from; row < values.size(); ++row) {
    if (std::isfinite(values[row])) {
      lastGood_[channel] = values[row];
      continue;
    }
    if (alone(row)) continue;
    std::size_t end = row + 1;
    while (end < values.size() && !std::isfinite(values[end]) && !alone(end)) ++end;
    const double before = lastGood_[channel],
                 after = end < values.size() && std::isfinite(values[end]) ? values[end] : before;
    reportChannel(channel, row, end);
    const auto span = static_cast<double>(end - row + 1);
    for (std::size_t i = row; i < end; ++i)
      values[i] = before + (after - before) * static_cast<double>(i - row + 1) / span;
    lastGood_[channel] = after;
    row = end - 1;
  }
}

// Markers of missing values: one of the usual numbers, at least three times, and far beyond all other values.
void RecordReader::findAbsent(const Rows& rows) {
  for (std::size_t c = 0; c < chosen_.channels.size(); ++c) {
    const auto& values = rows.columns[c];
    std::vector<double> sizes;
    for (const double value : values)
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
    const double usual = sizes.empty() ? 0 : signals::median(sizes);
    double found = HUGE_VAL;
    for (const double size : {999.0, 9999.0, 99999.0, 32768.0})
      for (const double sign : {-1.0, 1.0}) {
        const auto count = std::count(values.begin(), values.end(), sign * size);
        const bool apart =
            std::none_of(sizes.begin(), sizes.end(), [&](double s) { return s > 0.5 * size && s != size; });
        if (count >= 3 && size > 20 * usual && apart) found = sign * size;
      }
    absent_.push_back(found);
    if (std::isfinite(found))
      layout_.notes.push_back("'" + chosen_.channels[c].name + "': " + text::roundedText(found) +
                              " stands for no number, it seems: such samples are left out");
  }
}

void RecordReader::take(Rows& rows) {
  std::size_t k = 0;
  const auto append = [&](std::vector<double>& to, double factor, double absent = HUGE_VAL) {
    for (const double value : rows.columns[k]) {
      const double scaled = value * factor;
      to.push_back(std::abs(scaled) <= largest && value != absent ? scaled : std::nan(""));
    }
    ++k;
  };
  for (std::size_t c = 0; c < chosen_.channels.size(); ++c)
    append(work_.channels[c], chosen_.channels[c].factor, absent_.empty() ? HUGE_VAL : absent_[c]);
  const auto axis = [&](const std::vector<ChosenColumn>& column, std::vector<double>& to, double sign) {
    if (!column.empty()) append(to, column[0].factor * sign);
  };
  if (timesUsed_)
    axis(chosen_.time, work_.time, 1);
  else
    ++k;
  axis(chosen_.position, work_.position, direction_);
  axis(chosen_.speed, work_.speed, 1);
  axis(chosen_.run, work_.run, 1);
  axis(chosen_.latitude, work_.latitude, 1);
  axis(chosen_.longitude, work_.longitude, 1);
  // 0, 0 is what receivers write while they have no fix.
  constexpr double noFix = 1e-6;  // [deg]
  for (std::size_t i = work_.latitude.size() - (work_.latitude.empty() ? 0 : rows.size()); i < work_.latitude.size();
       ++i)
    if (std::abs(work_.latitude[i]) < noFix && std::abs(work_.longitude[i]) < noFix)
      work_.latitude[i] = work_.longitude[i] = std::nan("");
  work_.lines.insert(work_.lines.end(), rows.lines.begin(), rows.lines.end());
  for (std::size_t i = work_.size() - rows.size(); i < work_.speed.size(); ++i)
    work_.speed[i] = std::isfinite(work_.speed[i]) ? std::abs(work_.speed[i]) : i > 0 ? work_.speed[i - 1] : 0.0;
}

// What has come since `from` is filled and checked.
void RecordReader::check(std::size_t from) {
  if (work_.channels.size() > 1)
    for (std::size_t c = 0; c < work_.channels.size(); ++c) fillChannel(c, from);
  checks_->check(work_, ended_);
}

void RecordReader::reportTruncation() {
  const auto cut = source_->truncation();
  if (cut.empty()) return;
  RecordFault fault;
  fault.kind = FaultKind::truncated;
  fault.first = fault.end = work_.first + work_.size();
  if (!work_.time.empty()) fault.time = work_.time.back();
  if (work_.time.empty() && layout_.rate > 0) fault.time = static_cast<double>(fault.first) / layout_.rate;
  if (!work_.position.empty()) fault.position = work_.position.back() * direction_;
  fault.text = "the file is cut off: " + cut;
  fault.advice = "Copy it again from where it was recorded; what is there is read";
  faults_.add(std::move(fault));
}

void RecordReader::fetch() {
  const auto keep = static_cast<std::size_t>(speedWindow * layout_.rate) + 2;  // for speeds that look back
  if (at_ > keep) {
    work_.drop(at_ - keep);
    at_ = keep;
  }
  const std::size_t from = work_.size();
  if (source_->next(options_.blockLength, rows_)) {
    if (absent_.empty()) findAbsent(rows_);
    take(rows_);
    if (lostStep_ > 0) bridged_ += bridgeLostSamples(work_, std::max<std::size_t>(from, 1), lostStep_);
  } else {
    ended_ = true;
  }
  if (ended_) {
    layout_.samples = work_.first + work_.size();
    layout_.files = source_->files();
    if (const auto joined = source_->joined(); !joined.empty()) layout_.notes.push_back(joined);
  }
  if (ended_ && bridged_ > 0)
    layout_.notes.push_back(std::to_string(bridged_) +
                            " samples were lost, one to three at a time: straight lines stand for them");
  if (checks_) check(from);
  if (ended_) reportTruncation();
}

// End of the block that begins at at_; at_ where more rows are needed first.
std::size_t RecordReader::blockEnd() const {
  const std::size_t checked = work_.marks.size();
  std::size_t end = at_;
  while (end < checked && end - at_ < options_.blockLength && (end == at_ || work_.marks[end] == Mark::follows)) ++end;
  const bool full = end - at_ == options_.blockLength;
  const bool over = end < checked ? !full : ended_ && end == work_.size();
  if (over || end == at_) return end;
  if (!full) return at_;
  const std::size_t settled = checks_->settled();
  if (settled >= work_.first + end) return end;
  return settled > work_.first + at_ ? settled - work_.first
                                     : end;  // nothing settled in a whole block: it stands still
}

bool RecordReader::next(RecordBlock& block) {
  for (;;) {
    while (at_ < work_.marks.size() && work_.marks[at_] == Mark::bad) ++at_;
    const std::size_t end = at_ < work_.marks.size() ? blockEnd() : at_;
    if (end > at_) {
      emit(end, block);
      return true;
    }
    if (ended_) return false;
    fetch();
  }
}

void RecordReader::emit(std::size_t end, RecordBlock& block) {
  const auto part = [&](const std::vector<double>& values, std::vector<double>& to) {
    to.assign(values.begin() + static_cast<std::ptrdiff_t>(at_), values.begin() + static_cast<std::ptrdiff_t>(end));
  };
  block.first = work_.first + at_;
  block.time = work_.time.empty() ? static_cast<double>(block.first) / layout_.rate : work_.time[at_];
  block.follows = emitted_ && work_.marks[at_] == Mark::follows;
  if (!block.follows) stretchStart_ = block.first;
  emitted_ = true;
  block.values.resize(work_.channels.size());
  for (std::size_t c = 0; c < block.values.size(); ++c) part(work_.channels[c], block.values[c]);
  part(work_.position, block.position);
  if (!work_.speed.empty())
    part(work_.speed, block.speed);
  else if (!layout_.hasPosition)
    block.speed.assign(end - at_, options_.columns.speed);
  else
    speedsFromPositions(end, block);
  if (direction_ < 0)
    for (double& x : block.position) x = -x;
  block.latitude.clear();
  block.longitude.clear();
  if (layout_.hasCoordinates) {
    part(work_.latitude, block.latitude);
    part(work_.longitude, block.longitude);
    spreadRepeats(block.latitude, at_ > 0 ? work_.latitude[at_ - 1] : std::nan(""));
    spreadRepeats(block.longitude, at_ > 0 ? work_.longitude[at_ - 1] : std::nan(""));
  }
  at_ = end;
  checks_->release(work_.first + end);
}

// Rise over some tenths of a second, of what is settled and of this stretch.
void RecordReader::speedsFromPositions(std::size_t end, RecordBlock& block) const {
  const auto window = static_cast<std::size_t>(speedWindow * layout_.rate) + 1;
  const std::size_t from = stretchStart_ > work_.first ? stretchStart_ - work_.first : 0;
  std::size_t to = end;
  const std::size_t settled =
      std::clamp(checks_->settled(), work_.first, work_.first + work_.marks.size()) - work_.first;
  while (to < settled && work_.marks[to] == Mark::follows) ++to;
  block.speed.resize(end - at_);
  for (std::size_t i = at_; i < end; ++i) {
    const std::size_t low = i > from + window ? i - window : from, high = std::min(i + window, to - 1);
    block.speed[i - at_] = high > low ? std::max(0.0, (work_.position[high] - work_.position[low]) * layout_.rate /
                                                          static_cast<double>(high - low))
                                      : options_.columns.speed;
  }
}

}  // namespace squat::records
