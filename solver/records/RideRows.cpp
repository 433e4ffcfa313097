#include "records/RideRows.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/Errors.h"
#include "readers/ColumnRoles.h"
#include "readers/TableRoles.h"
#include "text/Text.h"

namespace squat::records {
namespace {

constexpr std::size_t firstRows = 1024;  // of a file, to see whether it follows
constexpr double longestPause = 1;       // [s] that a logger may need to change the file
constexpr double largestSteps = 3.5;     // steps between two files that make no pause

bool isDigit(char c) { return c >= '0' && c <= '9'; }

struct NumberedName {
  std::string rest;  // of the name, with a mark where the number stands
  long number = -1;  // -1: the name has none
};

// By the last number of the file's name.
NumberedName numberedName(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  std::size_t end = stem.size();
  while (end > 0 && !isDigit(stem[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && isDigit(stem[begin - 1]) && end - begin < 9) --begin;
  if (begin == end) return {stem, -1};
  return {std::filesystem::path(file).parent_path().string() + "/" + stem.substr(0, begin) + "*" + stem.substr(end),
          std::stol(stem.substr(begin, end - begin))};
}

bool namesFollow(const std::string& before, const std::string& file) {
  const auto a = numberedName(before), b = numberedName(file);
  return a.number >= 0 && b.number == a.number + 1 && a.rest == b.rest;
}

bool haveSameColumns(const text::DelimitedTable& a, const text::DelimitedTable& b) {
  if (a.columns.size() != b.columns.size()) return false;
  // A file that was cut out of a longer one has no heading.
  for (std::size_t c = 0; c < a.columns.size(); ++c)
    if (!b.columns[c].name.empty() &&
        (a.columns[c].name != b.columns[c].name || a.columns[c].unit != b.columns[c].unit))
      return false;
  return true;
}

}  // namespace

std::vector<std::string> inNumberOrder(std::vector<std::string> files) {
  for (const auto& file : files)
    if (numberedName(file).number < 0 || numberedName(file).rest != numberedName(files.front()).rest) return files;
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return numberedName(a).number < numberedName(b).number; });
  return files;
}

RideRows::RideRows(std::vector<std::string> files, const readers::SignalFileOptions& options, Together together)
    : files_(std::move(files)), options_(options), together_(together), current_(openRows(files_.front(), options)) {
  head_ = current_->head();
  rate = current_->rate, speed = current_->speed;
  signalColumn = current_->signalColumn, notes = current_->notes;
}

void RideRows::choose(std::vector<std::size_t> columns) {
  chosen_ = std::move(columns);
  auto table = head_;
  readers::setUnits(table, options_);
  const auto roles = readers::rolesOf(table, options_);
  const auto axisOf = [&](std::size_t column, readers::Role role) {
    Axis axis;
    const auto found = std::find(chosen_.begin(), chosen_.end(), column);
    if (column == readers::noColumn || found == chosen_.end()) return axis;
    axis.at = static_cast<std::size_t>(found - chosen_.begin());
    axis.scale = readers::scaleOf(table.columns[column].unit, table.columns[column].name, role).factor;
    const auto& values = table.columns[column].values;
    axis.first = values.empty() ? 0 : values.front();
    return axis;
  };
  time_ = axisOf(roles.time, readers::Role::time);
  position_ = axisOf(roles.position, readers::Role::position);
  current_->choose(chosen_);
}

// Where the axes have come to. A step is the mean over the last rows: encoders repeat their positions.
void RideRows::remember(const Rows& rows) {
  for (auto* axis : {&time_, &position_}) {
    if (!axis->exists() || rows.size() == 0) continue;
    const auto& values = rows.columns[axis->at];
    std::size_t last = values.size() - 1;
    while (last > 0 && !std::isfinite(values[last])) --last;
    if (!std::isfinite(values[last])) continue;
    axis->last = values[last];
    std::size_t first = last > 200 ? last - 200 : 0;
    while (first < last && !std::isfinite(values[first])) ++first;
    if (first < last) axis->step = (values[last] - values[first]) / static_cast<double>(last - first);
  }
  if (!rows.lines.empty()) lines_ = rows.lines.back();
}

void RideRows::carryOn(Rows& rows) {
  if (timeShift_ != 0)
    for (double& time : rows.columns[time_.at]) time += timeShift_;
  for (auto& line : rows.lines) line += lineShift_;
}

bool RideRows::next(std::size_t maximum, Rows& rows) {
  if (pending_.size() > 0) {
    std::swap(rows, pending_);
    pending_ = {};
    remember(rows);
    return true;
  }
  if (!current_->next(maximum, rows)) {
    if (!openNext()) return false;
    return next(maximum, rows);
  }
  carryOn(rows);
  remember(rows);
  return true;
}

bool RideRows::openNext() {
  if (at_ + 1 >= files_.size()) return false;
  auto following = openRows(files_[at_ + 1], options_);
  if (options_.headLine > 0 && !haveSameColumns(head_, following->head())) {
    auto headless = options_;
    headless.headLine = 0;
    following = openRows(files_[at_ + 1], headless);
  }
  following->choose(chosen_);
  pending_ = {};
  pending_.columns.resize(chosen_.size());
  following->next(firstRows, pending_);
  const Join join = joinOf(following->head(), following->rate);
  if (join == Join::none) {
    pending_ = {};
    return false;
  }
  join_ = join_ == Join::none ? join : join_;
  if (const auto cut = current_->truncation(); !cut.empty())
    truncation_ += (truncation_.empty() ? "" : "; ") + files_[at_] + ": " + cut;
  lineShift_ = lines_;
  current_ = std::move(following);
  ++at_;
  carryOn(pending_);
  return true;
}

RideRows::Join RideRows::joinOf(const text::DelimitedTable& head, double nextRate) {
  const auto& file = files_[at_ + 1];
  if (!haveSameColumns(head_, head) || nextRate != rate || pending_.size() == 0) {
    if (together_ != Together::consecutive && !namesFollow(files_[at_], file)) return Join::none;
    throw FileError(
        file, "", "has other columns, or another rate, than " + files_.front(),
        "Files of one ride hold the same columns, in the same units, at the same rate; --passes reads them apart");
  }
  const auto firstOf = [&](const Axis& axis) {
    const auto& values = pending_.columns[axis.at];
    const auto finite = std::find_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    return finite == values.end() ? values.front() : *finite;
  };
  timeShift_ = 0;
  bool startsAgain = false, goesBack = false;
  if (time_.exists()) {
    // A clock begins again at midnight.
    constexpr double day = 86400;  // [s]
    const bool isClock = head_.columns[chosen_[time_.at]].moments == text::MomentKind::clock;
    while (isClock && firstOf(time_) + timeShift_ < time_.last - day / 2) timeShift_ += day;
    const double pause = firstOf(time_) + timeShift_ - time_.last;
    if (pause > 0.2 * time_.step && pause <= std::max(largestSteps * time_.step, longestPause / time_.scale))
      return Join::followingTimes;
    startsAgain = std::abs(firstOf(time_) - time_.first) * time_.scale <= longestPause;
    goesBack = pause <= 0 && !startsAgain;
    if (startsAgain && std::isfinite(firstOf(time_))) timeShift_ = time_.last + time_.step - firstOf(time_);
  }
  if (position_.exists() && (startsAgain || !time_.exists())) {
    constexpr double shortWay = 0.5;  // [m]
    const double way = (firstOf(position_) - position_.last) * (position_.step < 0 ? -1 : 1);
    const auto& next = pending_.columns[position_.at];
    const bool isSameWay = (next.back() - next.front()) * position_.step > 0;  // not back again
    if (isSameWay && way >= 0 && way <= std::max(largestSteps * std::abs(position_.step), shortWay / position_.scale))
      return Join::followingPositions;
    if (together_ == Together::consecutive) goesBack = goesBack || way < 0;
  }
  if (together_ == Together::consecutive) return joinAsStated(goesBack, file);
  if (!position_.exists() && namesFollow(files_[at_], file))
    throw CaseError({{"--consecutive, --passes", "neither", "one of both",
                      file + " follows on " + files_[at_] +
                          " by its name, but its times and positions do not: are they parts of one ride "
                          "(--consecutive), or passes over the same track (--passes)?"}});
  return Join::none;
}

RideRows::Join RideRows::joinAsStated(bool goesBack, const std::string& file) const {
  if (goesBack)
    throw FileError(file, "", "begins before " + files_[at_] + " ends",
                    "Give the files in the order in which they were recorded, or --passes for passes over one track");
  return Join::asStated;
}

std::string RideRows::truncation() const {
  const auto cut = current_->truncation();
  return truncation_ + (truncation_.empty() || cut.empty() ? "" : "; ") + cut;
}

double RideRows::fraction() const {
  if (at_ == 0 && together_ != Together::consecutive) return current_->fraction();
  return (static_cast<double>(at_) + current_->fraction()) / static_cast<double>(files_.size());
}

std::vector<std::string> RideRows::files() const {
  return {files_.begin(), files_.begin() + static_cast<std::ptrdiff_t>(at_ + 1)};
}

std::string RideRows::joined() const {
  if (at_ == 0) return {};
  const std::string why = join_ == Join::asStated         ? "as --consecutive says"
                          : join_ == Join::followingTimes ? "their times follow on"
                                                          : "their positions follow on";
  return std::to_string(at_ + 1) + " files are read as one ride, to " + files_[at_] + ": " + why +
         " (--passes reads them apart); lines are counted through all";
}

}  // namespace squat::records
