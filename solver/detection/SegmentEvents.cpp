#include "detection/SegmentEvents.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signals/DecimatingFilter.h"

namespace squat::detection {
namespace {

// A row of samples, one value for each cell: that in its middle.
std::vector<double> atCells(const std::vector<double>& values, const BandPower& power) {
  std::vector<double> result(power.cells());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = values[std::min(values.size() - 1, i * power.cell + power.cell / 2)];
  return result;
}

std::vector<double> travelledBy(const std::vector<double>& speed, double step) {
  std::vector<double> result(speed.size(), 0.0);
  for (std::size_t i = 1; i < speed.size(); ++i) result[i] = result[i - 1] + std::max(0.0, speed[i]) * step;
  return result;
}

bool isStill(const signals::TimeSeries& series) {
  const auto [low, high] = std::minmax_element(series.values.begin(), series.values.end());
  return series.values.size() < 64 || !(*high > *low);
}

// Cells in which the channel keeps one value for a quarter of a second, and those near them: where it begins and ends
// to do so, its offset jumps, which is no event. Empty: there are none.
std::vector<bool> silentCells(const signals::TimeSeries& series, const BandPower& power) {
  constexpr double shortest = 0.25, margin = 0.1;  // [s]; the longest wavelets decay within the margin
  const auto& values = series.values;
  const auto enough = static_cast<std::size_t>(shortest / series.step);
  const auto beside = static_cast<std::ptrdiff_t>(margin / power.step) + 1;
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  std::vector<bool> silent;
  for (std::size_t i = 0, end = 0; i < values.size(); i = end) {
    end = i + 1;
    while (end < values.size() && std::abs(values[end] - values[i]) <= 1e-9 * largest) ++end;
    if (end - i < enough) continue;
    silent.resize(power.cells(), false);
    const auto first = std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(i / power.cell) - beside);
    const auto last =
        std::min(static_cast<std::ptrdiff_t>(power.cells()), static_cast<std::ptrdiff_t>(end / power.cell) + beside);
    std::fill(silent.begin() + first, silent.begin() + std::max(first, last), true);
  }
  return silent;
}

double peakAround(const Segment& segment, std::size_t channel, std::size_t sample) {
  const auto& series = segment.channels[channel];
  const auto near = static_cast<std::size_t>(0.3 / (segment.speed[sample] * series.step));
  double peak = 0;
  for (std::size_t i = sample > near ? sample - near : 0; i < std::min(series.values.size(), sample + near); ++i)
    peak = std::max(peak, std::abs(series.values[i]));
  return peak;
}

std::size_t sampleOf(const BandPower& power, std::size_t cell, const signals::TimeSeries& series) {
  return std::min(series.values.size() - 1, cell * power.cell + power.cell / 2);
}

Event eventAt(const Segment& segment, std::size_t channel, const std::vector<double>& travelled, const BandPower& power,
              const Candidate& candidate) {
  const auto& series = segment.channels[channel];
  const auto sample = sampleOf(power, candidate.anchor, series);
  Event event;
  event.channel = series.name, event.unit = series.unit;
  event.time = series.timeAt(sample);
  event.position = segment.position[sample];
  event.travelled = travelled[candidate.anchor];
  const bool hasCoordinates = !segment.latitude.empty() && !segment.longitude.empty();
  event.latitude = hasCoordinates ? segment.latitude[sample] : std::numeric_limits<double>::quiet_NaN();
  event.longitude = hasCoordinates ? segment.longitude[sample] : std::numeric_limits<double>::quiet_NaN();
  event.score = candidate.score;
  const double perSample = segment.speed[sample] * series.step;
  const auto ahead = static_cast<std::size_t>(0.5 / perSample), behind = static_cast<std::size_t>(1.0 / perSample);
  const std::size_t from = sample > ahead ? sample - ahead : 0, to = std::min(series.values.size(), sample + behind);
  event.passage = {series.timeAt(from),
                   series.step,
                   {series.values.begin() + static_cast<std::ptrdiff_t>(from),
                    series.values.begin() + static_cast<std::ptrdiff_t>(to)},
                   series.name,
                   series.unit};
  event.peak = peakAround(segment, channel, sample);
  return event;
}

// `evidence`: a value for each `cell` samples; empty: there is none.
std::vector<Piece> piecesOf(const Segment& segment, std::size_t channel, const std::vector<double>& evidence,
                            std::size_t cell) {
  std::vector<Piece> pieces;
  const auto& series = segment.channels[channel];
  double way = pieceLength, squares = 0;
  std::size_t count = 0;
  const auto close = [&] {
    if (count > 0) pieces.back().rms = std::sqrt(squares / static_cast<double>(count));
    squares = 0, count = 0;
  };
  for (std::size_t i = 0; i < series.values.size(); ++i) {
    const double time = series.timeAt(i);
    if (time < segment.coreStart || time >= segment.coreEnd) continue;
    if (way >= pieceLength) {
      close();
      pieces.push_back({segment.position[i], 0, 0, 0});
      way = std::fmod(way, pieceLength);
    }
    way += std::max(0.0, segment.speed[i]) * series.step;
    squares += series.values[i] * series.values[i], ++count;
    pieces.back().peak = std::max(pieces.back().peak, std::abs(series.values[i]));
    if (const auto at = i / cell; at < evidence.size())
      pieces.back().evidence = std::max(pieces.back().evidence, evidence[at]);
  }
  close();
  return pieces;
}

// As candidates are anchored, around the largest power; each band counts by its width, as white noise would weigh it.
std::size_t passageAnchor(const BandPower& power, const Evidence& silence) {
  std::vector<double> sum(power.cells(), 0.0);
  for (std::size_t b = 1; b < bandCount; ++b)
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += power.power[b][i] / (detectionBands()[b].high - detectionBands()[b].low);
  const auto loudest = static_cast<std::size_t>(std::max_element(sum.begin(), sum.end()) - sum.begin());
  const auto half = static_cast<std::size_t>(12e-3 / power.step);
  return anchorIn(power, silence.level, loudest > half ? loudest - half : 0, std::min(sum.size(), loudest + half));
}

// With silence on both sides, longer than the longest wavelet; the end of the record fades into it.
Segment inSilence(const signals::TimeSeries& passage, const std::vector<double>& position,
                  const signals::TimeSeries* other) {
  const std::size_t n = passage.values.size();
  const double speed = (position.back() - position.front()) / (passage.step * static_cast<double>(n - 1));
  const auto pad = static_cast<std::size_t>(std::max(0.1, 2.0 / speed) / passage.step);
  const std::size_t fade = n / 20;
  records::RecordLayout layout;
  layout.rate = passage.rate();
  records::RecordBlock block;
  block.time = passage.start - passage.step * static_cast<double>(pad);
  for (const auto* each : {&passage, other}) {
    if (!each) continue;
    layout.channels.push_back({each->name, each->unit});
    auto& values = block.values.emplace_back(n + 2 * pad, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t toEnd = n - 1 - i;
      const double gain = toEnd < fade ? static_cast<double>(toEnd) / static_cast<double>(fade) : 1.0;
      values[pad + i] = gain * each->values[i];
    }
  }
  block.speed.assign(n + 2 * pad, speed);
  for (std::size_t i = 0; i < n + 2 * pad; ++i)
    block.position.push_back(position.front() +
                             speed * passage.step * (static_cast<double>(i) - static_cast<double>(pad)));
  SegmentCutter cutter(layout);
  cutter.push(block);
  return std::move(cutter.finish().front());
}

}  // namespace

SegmentEvents segmentEvents(const Segment& segment, std::size_t channel, double threshold,
                            std::optional<std::size_t> other) {
  SegmentEvents found;
  const auto& series = segment.channels[channel];
  if (isStill(series)) {
    found.pieces = piecesOf(segment, channel, {}, 1);
    return found;
  }
  const auto power = bandPower(series);
  const auto speed = atCells(segment.speed, power);
  const auto travelled = travelledBy(speed, power.step);
  const auto evidence = evidenceOf(power, series.rate(), speed, silentCells(series, power));
  found.pieces = piecesOf(segment, channel, evidence.value, power.cell);
  found.waves = wavyStretches(segment, channel, power);
  for (const auto& candidate : candidatesIn(power, evidence, travelled, threshold)) {
    const double time = power.timeAt(candidate.anchor);
    if (time < segment.coreStart || time >= segment.coreEnd || speed[candidate.anchor] < minimumSpeed) continue;
    auto event = eventAt(segment, channel, travelled, power, candidate);
    event.features = eventFeatures(power, evidence, series.rate(), speed, travelled, candidate.anchor);
    if (other) {
      const auto sample = sampleOf(power, candidate.anchor, series);
      event.arrival = firstArrival(series, segment.channels[*other], sample, speed[candidate.anchor]);
      event.otherPeak = peakAround(segment, *other, sample);
    }
    found.events.push_back(std::move(event));
  }
  return found;
}

PassageFeatures passageFeatures(const signals::TimeSeries& passage, const std::vector<double>& position,
                                const signals::TimeSeries* other) {
  const auto segment = inSilence(passage, position, other);
  const auto& series = segment.channels.front();
  const auto power = bandPower(series);
  const auto speed = atCells(segment.speed, power);
  Evidence silence;
  silence.level.assign(bandCount, std::vector<double>(power.cells(), 0.0));
  const std::size_t anchor = passageAnchor(power, silence);
  PassageFeatures found;
  found.features = eventFeatures(power, silence, series.rate(), speed, travelledBy(speed, power.step), anchor);
  found.offset = atCells(segment.position, power)[anchor];
  if (other)
    found.arrival = firstArrival(series, segment.channels.back(), sampleOf(power, anchor, series), speed[anchor]);
  return found;
}

}  // namespace squat::detection
