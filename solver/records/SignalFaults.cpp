#include "records/SignalFaults.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signals/Median.h"
#include "text/Numbers.h"

namespace squat::records {
namespace {

constexpr std::size_t neighbours = 8;            // on each side of a spike
constexpr std::size_t longestSpike = 3;          // [samples]
constexpr double standsOut = 5;                  // from its neighbours
constexpr double farOut = 20;                    // robust deviations of the block
constexpr double countsOut = 8;                  // steps of the converter
constexpr std::size_t shortestFlat = 3;          // [samples] at the limit in a row
constexpr std::size_t fewestFlat = 8;            // of a block
constexpr double limitAt = 10;                   // robust deviations: what is less is a coarse converter at rest
constexpr double deadSeconds = 0.5, slow = 1.0;  // [s], [m/s]
constexpr double sameEvent = 0.1;                // [s] between runs at the limit that are one fault

struct Spread {
  double median = 0;
  double deviation = 0;  // robust: 1.4826 median absolute deviations, a tenth of the root mean square at least
  double step = 0;       // smallest difference of two values: of the converter
};

Spread spreadOf(const std::vector<double>& values) {
  Spread spread;
  std::vector<double> some, sizes;
  double squares = 0;
  for (std::size_t i = 0; i < values.size(); i += 16) some.push_back(values[i]);
  for (std::size_t i = 1; i < some.size(); ++i)
    if (const double step = std::abs(some[i] - some[i - 1]); step > 0 && (spread.step == 0 || step < spread.step))
      spread.step = step;
  spread.median = signals::median(some);
  for (const double value : some) {
    sizes.push_back(std::abs(value - spread.median));
    squares += sizes.back() * sizes.back();
  }
  const double rms = sizes.empty() ? 0 : std::sqrt(squares / static_cast<double>(sizes.size()));
  spread.deviation = std::max(1.4826 * signals::median(sizes), 0.1 * rms);
  return spread;
}

}  // namespace

CheckedRecord::CheckedRecord(std::unique_ptr<RecordStream> source)
    : source_(std::move(source)), channels_(source_->layout().channels.size()), all_(source_->faults()) {}

bool CheckedRecord::next(RecordBlock& block) {
  if (!hasAhead_ && !(hasAhead_ = source_->next(ahead_))) {
    all_ = source_->faults();
    all_.insert(all_.end(), found_.list().begin(), found_.list().end());
    return false;
  }
  std::swap(block, ahead_);
  hasAhead_ = source_->next(ahead_);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    auto& channel = channels_[c];
    if (!block.follows) channel = {};
    const auto& values = block.values[c];
    const auto spread = spreadOf(values);
    const double enough = std::max(farOut * spread.deviation, countsOut * spread.step);
    std::vector<double> last(values.end() - static_cast<std::ptrdiff_t>(std::min(values.size(), neighbours)),
                             values.end());
    findDead(block, c);
    findSaturation(block, c, spread.median, spread.deviation);
    mendSpikes(block, c, spread.median, enough);
    channel.before = std::move(last);
  }
  all_ = source_->faults();
  all_.insert(all_.end(), found_.list().begin(), found_.list().end());
  return true;
}

RecordFault CheckedRecord::faultAt(FaultKind kind, const RecordBlock& block, std::size_t from, std::size_t to,
                                   std::size_t channel) const {
  RecordFault fault;
  fault.kind = kind;
  fault.first = block.first + from, fault.end = block.first + to;
  fault.time = block.time + static_cast<double>(from) / layout().rate;
  fault.position = block.position[from];
  fault.channel = static_cast<int>(channel);
  return fault;
}

void CheckedRecord::mendSpikes(RecordBlock& block, std::size_t channel, double median, double enough) {
  auto& values = block.values[channel];
  const auto& before = channels_[channel].before;
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  // Largest deviation of samples [from, to), those of the neighbouring blocks included; how many there are.
  const auto around = [&](std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t& count) {
    double largest = 0;
    for (std::ptrdiff_t i = from; i < to; ++i) {
      const auto back = static_cast<std::ptrdiff_t>(before.size()) + i;
      const bool isAhead = i >= size && hasAhead_ && ahead_.follows &&
                           i - size < static_cast<std::ptrdiff_t>(ahead_.values[channel].size());
      if ((i < 0 && back < 0) || (i >= size && !isAhead)) continue;
      const double value = i < 0       ? before[static_cast<std::size_t>(back)]
                           : i >= size ? ahead_.values[channel][static_cast<std::size_t>(i - size)]
                                       : values[static_cast<std::size_t>(i)];
      largest = std::max(largest, std::abs(value - median));
      ++count;
    }
    return largest;
  };
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    const auto sizeAt = [&](std::ptrdiff_t k) { return std::abs(values[static_cast<std::size_t>(k)] - median); };
    if (!(sizeAt(i) > enough)) continue;
    std::ptrdiff_t end = i + 1, there = 0;
    double smallest = sizeAt(i), largest = smallest;
    while (end < size && end - i < static_cast<std::ptrdiff_t>(longestSpike) && sizeAt(end) > enough) {
      smallest = std::min(smallest, sizeAt(end)), largest = std::max(largest, sizeAt(end));
      ++end;
    }
    constexpr auto reach = static_cast<std::ptrdiff_t>(neighbours);
    const double beside = std::max(around(i - reach, i, there), around(end, end + reach, there));
    if (there < reach || !(smallest > standsOut * beside)) {
      i = end - 1;
      continue;
    }
    auto fault = faultAt(FaultKind::spike, block, static_cast<std::size_t>(i), static_cast<std::size_t>(end), channel);
    fault.text = "'" + layout().channels[channel].name + "' has a spike of " + text::roundedText(largest) + " " +
                 layout().channels[channel].unit + " in " +
                 (end - i == 1 ? "one sample" : std::to_string(end - i) + " samples");
    fault.advice = "A straight line replaces it; check for a loose contact or lost data";
    found_.add(std::move(fault));
    const double left = i > 0 ? values[static_cast<std::size_t>(i - 1)] : before.empty() ? median : before.back();
    const double right = end < size                    ? values[static_cast<std::size_t>(end)]
                         : hasAhead_ && ahead_.follows ? ahead_.values[channel].front()
                                                       : left;
    for (std::ptrdiff_t k = i; k < end; ++k)
      values[static_cast<std::size_t>(k)] =
          left + (right - left) * static_cast<double>(k - i + 1) / static_cast<double>(end - i + 1);
    i = end - 1;
  }
}

void CheckedRecord::findSaturation(const RecordBlock& block, std::size_t channel, double median, double deviation) {
  const auto& values = block.values[channel];
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  for (const double limit : {*high, *low}) {
    if (!(std::abs(limit - median) > limitAt * deviation)) continue;
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    std::size_t flat = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] != limit) continue;
      std::size_t end = i + 1;
      while (end < values.size() && values[end] == limit) ++end;
      if (end - i >= shortestFlat) runs.emplace_back(i, end), flat += end - i;
      i = end;
    }
    if (flat < fewestFlat) continue;
    for (std::size_t k = 0; k < runs.size();) {
      std::size_t last = k;
      while (last + 1 < runs.size() &&
             static_cast<double>(runs[last + 1].first - runs[last].second) < sameEvent * layout().rate)
        ++last;
      auto fault = faultAt(FaultKind::saturation, block, runs[k].first, runs[last].second, channel);
      fault.text = "'" + layout().channels[channel].name + "' is cut off at " + text::roundedText(limit) + " " +
                   layout().channels[channel].unit;
      fault.advice =
          "The acceleration was larger than recorded, and the defect may be more severe; record with a larger range";
      found_.add(std::move(fault));
      k = last + 1;
    }
  }
}

void CheckedRecord::findDead(const RecordBlock& block, std::size_t channel) {
  auto& state = channels_[channel];
  const auto enough = static_cast<std::size_t>(std::max(16.0, deadSeconds * layout().rate));
  const auto& values = block.values[channel];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (state.same > 0 && values[i] == state.last && block.speed[i] > slow) {
      ++state.same;
    } else {
      if (state.isDead) found_.extend(state.deadFault, block.first + i);
      state.isDead = false, state.same = 1, state.last = values[i];
    }
    if (state.same != enough || state.isDead) continue;
    auto fault = faultAt(FaultKind::deadChannel, block, i, i + 1, channel);
    const auto ago = static_cast<double>(enough - 1) / layout().rate;
    fault.first -= enough - 1, fault.time -= ago;
    fault.position -= (layout().falling ? -1 : 1) * block.speed[i] * ago;
    fault.text = "'" + layout().channels[channel].name + "' stays at " + text::roundedText(state.last) + " " +
                 layout().channels[channel].unit;
    fault.advice = "No events are looked for there; check the sensor and its cable";
    state.deadFault = found_.add(std::move(fault));
    state.isDead = true;
  }
  if (state.isDead) found_.extend(state.deadFault, block.first + values.size());
}

}  // namespace squat::records
