#include "records/Overview.h"

#include <algorithm>
#include <cmath>

namespace squat::records {

namespace {

constexpr double kFarthest = 1e9;  // [m] of a position that is one

long stretchOf(double position) { return static_cast<long>(std::floor(position / Overview::stretch)); }

}  // namespace

Overview::Extreme* Overview::Side::at(long index) {
  auto& side = index >= 0 ? up : down;
  const auto place = static_cast<std::size_t>(index >= 0 ? index : -index - 1);
  if (place >= maximum / 2) return nullptr;
  if (place >= side.size()) side.resize(place + 1);
  return &side[place];
}

const Overview::Extreme* Overview::Side::find(long index) const {
  const auto& side = index >= 0 ? up : down;
  const auto place = static_cast<std::size_t>(index >= 0 ? index : -index - 1);
  return place < side.size() ? &side[place] : nullptr;
}

void Overview::add(const RecordLayout& layout, const RecordBlock& block) {
  const std::lock_guard lock(mutex_);
  if (channels_.empty()) channels_ = layout.channels, sides_.resize(channels_.size());
  for (std::size_t c = 0; c < std::min(sides_.size(), block.values.size()); ++c) {
    const auto& values = block.values[c];
    Extreme* extreme = nullptr;
    long known = 0;
    for (std::size_t i = 0; i < std::min(values.size(), block.size()); ++i) {
      if (!std::isfinite(values[i]) || !(std::abs(block.position[i]) < kFarthest)) continue;
      const long number = stretchOf(block.position[i]);
      if (!begun_) begun_ = true, first_ = lowest_ = highest_ = number;
      if (!extreme || number != known) {
        extreme = sides_[c].at(number - first_);
        known = number;
        if (extreme) lowest_ = std::min(lowest_, number), highest_ = std::max(highest_, number);
      }
      if (!extreme) continue;
      const auto value = static_cast<float>(values[i]);
      if (extreme->low > extreme->high)
        extreme->low = extreme->high = value;
      else
        extreme->low = std::min(extreme->low, value), extreme->high = std::max(extreme->high, value);
    }
  }
}

std::vector<RecordChannel> Overview::channels() const {
  const std::lock_guard lock(mutex_);
  return channels_;
}

std::pair<double, double> Overview::extent() const {
  const std::lock_guard lock(mutex_);
  if (!begun_) return {0, 0};
  return {stretch * static_cast<double>(lowest_), stretch * static_cast<double>(highest_ + 1)};
}

Envelope Overview::envelope(std::size_t channel, double from, double to, std::size_t points) const {
  const std::lock_guard lock(mutex_);
  Envelope envelope;
  if (!begun_ || channel >= sides_.size() || !(to > from) || points == 0) return envelope;
  const auto& side = sides_[channel];
  const double low = static_cast<double>(lowest_), high = static_cast<double>(highest_);
  const long begin = static_cast<long>(std::clamp(std::floor(from / stretch), low, high));
  const long end = static_cast<long>(std::clamp(std::floor(to / stretch), low, high)) + 1;
  const long group = std::max(1L, (end - begin) / static_cast<long>(points));
  // Groups begin at multiples of their length: a strip that is scrolled does not flicker.
  for (long at = begin - ((begin % group) + group) % group; at < end; at += group) {
    Extreme all;
    for (long i = at; i < at + group; ++i) {
      const auto* one = side.find(i - first_);
      if (!one || one->low > one->high) continue;
      if (all.low > all.high)
        all = *one;
      else
        all.low = std::min(all.low, one->low), all.high = std::max(all.high, one->high);
    }
    if (all.low > all.high) continue;
    envelope.position.push_back(stretch * (static_cast<double>(at) + 0.5 * static_cast<double>(group)));
    envelope.low.push_back(all.low), envelope.high.push_back(all.high);
  }
  return envelope;
}

bool OverviewedStream::next(RecordBlock& block) {
  if (!stream_->next(block)) return false;
  overview_->add(stream_->layout(), block);
  return true;
}

}  // namespace squat::records
