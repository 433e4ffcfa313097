#include "roughness/RecordRoughness.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"

namespace squat::roughness {

std::vector<double> speedsOf(const std::vector<double>& position, double rate) {
  constexpr double reach = 0.05;  // [s]
  const auto n = static_cast<long>(position.size()), step = std::max(1L, std::lround(reach * rate));
  std::vector<double> speed;
  for (long i = 0; i < n; ++i) {
    const long from = std::max(0L, i - step), to = std::min(n - 1, i + step);
    speed.push_back((position[static_cast<std::size_t>(to)] - position[static_cast<std::size_t>(from)]) * rate /
                    static_cast<double>(std::max(1L, to - from)));
  }
  return speed;
}

RecordRoughness roughnessOf(const signals::Passage& passage, const TransferFunction& transfer,
                            const GaugeOptions& options) {
  const auto& series = passage.series;
  if (series.unit != "m/s2" && !series.unit.empty())
    throw CaseError({{"--roughness", series.name + " [" + series.unit + "]", "a signal in m/s2",
                      "Name the column of the axle box acceleration with --column"}});
  RoughnessGauge gauge(transfer, series.rate(), options);
  gauge.add(series.values, speedsOf(passage.position, series.rate()));
  auto result = gauge.finish();
  if (series.unit.empty()) result.notes.emplace_back("the signal states no unit: taken as m/s2");
  return result;
}

GaugedStream::GaugedStream(std::unique_ptr<records::RecordStream> stream, const TransferFunction& transfer,
                           const GaugeOptions& options)
    : stream_(std::move(stream)), transfer_(transfer), options_(options) {}

bool GaugedStream::next(records::RecordBlock& block) {
  if (!stream_->next(block)) return false;
  if (gauges_.empty())
    for (std::size_t i = 0; i < block.values.size(); ++i)
      gauges_.emplace_back(transfer_, stream_->layout().rate, options_);
  for (std::size_t i = 0; i < gauges_.size() && i < block.values.size(); ++i) {
    if (!block.follows) gauges_[i].breakHere();
    gauges_[i].add(block.values[i], block.speed);
  }
  return true;
}

std::vector<std::pair<std::string, RecordRoughness>> GaugedStream::finish() {
  std::vector<std::pair<std::string, RecordRoughness>> list;
  const auto& channels = stream_->layout().channels;
  for (std::size_t i = 0; i < gauges_.size(); ++i)
    list.emplace_back(i < channels.size() ? channels[i].name : std::string(), gauges_[i].finish());
  return list;
}

}  // namespace squat::roughness
