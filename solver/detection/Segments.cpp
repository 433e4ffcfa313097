#include "detection/Segments.h"

#include <algorithm>
#include <cmath>

#include "signals/DecimatingFilter.h"
#include "signals/Median.h"

namespace squat::detection {
namespace {

constexpr double highestFrequency = 2000;  // [Hz] that is looked at
constexpr double minimumRate = 5000;       // [Hz] that shows it, with room for the filter's edge

std::size_t factorFor(double rate) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(rate / minimumRate * (1 + 1e-9))));
}

// An offset of the sensor would ring at the ends of the stretch.
void takeOffsetAway(std::vector<double>& values) {
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); i += 16) some.push_back(values[i]);
  const double offset = signals::median(std::move(some));
  for (auto& value : values) value -= offset;
}

signals::TimeSeries decimated(const std::vector<double>& values, double start, double step, std::size_t factor) {
  if (factor < 2) return {start, step, values, {}, {}};
  signals::DecimatingFilterOptions options;
  options.passEdge = highestFrequency;
  options.stopEdge = 1 / (step * static_cast<double>(factor)) - highestFrequency;
  options.stopAttenuation = 60;
  signals::DecimatingFilter filter(step, factor, 1, options);
  for (const double value : values) filter.push(&value);
  return std::move(filter.finish(start).front());
}

std::vector<double> everyNth(const std::vector<double>& values, std::size_t factor, std::size_t count) {
  std::vector<double> result;
  result.reserve(count);
  for (std::size_t i = 0; i < values.size() && result.size() < count; i += factor) result.push_back(values[i]);
  return result;
}

}  // namespace

SegmentCutter::SegmentCutter(const records::RecordLayout& layout, std::size_t coreSamples, double marginMetres)
    : step_(1 / layout.rate), factor_(factorFor(layout.rate)), core_(coreSamples), margin_(marginMetres) {
  for (const auto& channel : layout.channels) names_.push_back(channel.name), units_.push_back(channel.unit);
  values_.resize(names_.size());
}

double SegmentCutter::rate() const { return 1 / (step_ * static_cast<double>(factor_)); }

// Samples that cover the margin at the speed of the core's end, at least one second, at most half a core.
std::size_t SegmentCutter::marginSamples() const {
  const double speed = speed_.empty() ? 0 : speed_[std::min(speed_.size() - 1, kept_ + core_)];
  const double seconds = std::max(1.0, speed > 0 ? margin_ / speed : 0.0);
  const auto samples = std::min(static_cast<std::size_t>(seconds / step_), core_ / 2);
  return (samples + factor_ - 1) / factor_ * factor_;  // segments begin on the grid of the reduced rate
}

void SegmentCutter::append(const records::RecordBlock& block) {
  if (position_.empty()) start_ = block.time;
  const auto add = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (std::size_t c = 0; c < values_.size(); ++c) add(values_[c], block.values[c]);
  add(position_, block.position);
  add(speed_, block.speed);
  add(latitude_, block.latitude);
  add(longitude_, block.longitude);
}

Segment SegmentCutter::cut(std::size_t end, bool isLast) {
  Segment segment;
  segment.coreStart = start_ + step_ * static_cast<double>(kept_);
  segment.coreEnd = start_ + step_ * static_cast<double>(end);
  if (isLast) segment.coreEnd += step_;
  // What came beyond the margin with the last block belongs to the next segment alone.
  const std::size_t shown = isLast ? position_.size() : std::min(position_.size(), end + marginSamples());
  for (std::size_t c = 0; c < values_.size(); ++c) {
    std::vector<double> values(values_[c].begin(), values_[c].begin() + static_cast<std::ptrdiff_t>(shown));
    takeOffsetAway(values);
    segment.channels.push_back(decimated(values, start_, step_, factor_));
    segment.channels.back().name = names_[c];
    segment.channels.back().unit = units_[c];
  }
  const std::size_t count = segment.channels.empty() ? 0 : segment.channels.front().values.size();
  segment.position = everyNth(position_, factor_, count);
  segment.speed = everyNth(speed_, factor_, count);
  segment.latitude = everyNth(latitude_, factor_, count);
  segment.longitude = everyNth(longitude_, factor_, count);
  return segment;
}

void SegmentCutter::drop(std::size_t samples) {
  const auto erase = [&](std::vector<double>& values) {
    if (!values.empty()) values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(samples));
  };
  for (auto& values : values_) erase(values);
  for (auto* values : {&position_, &speed_, &latitude_, &longitude_}) erase(*values);
  start_ += step_ * static_cast<double>(samples);
}

std::vector<Segment> SegmentCutter::push(const records::RecordBlock& block) {
  std::vector<Segment> complete;
  if (!block.follows) complete = flush();
  append(block);
  while (position_.size() >= kept_ + core_ + marginSamples()) {
    const std::size_t margin = marginSamples(), end = kept_ + core_;
    auto segment = cut(end, false);
    complete.push_back(std::move(segment));
    const std::size_t from = (end - std::min(end, margin)) / factor_ * factor_;
    drop(from);
    kept_ = end - from;
  }
  return complete;
}

std::vector<Segment> SegmentCutter::flush() {
  std::vector<Segment> last;
  if (position_.size() > kept_) last.push_back(cut(position_.size(), true));
  drop(position_.size());
  kept_ = 0;
  return last;
}

std::vector<Segment> SegmentCutter::finish() { return flush(); }

}  // namespace squat::detection
