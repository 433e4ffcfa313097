#include "plots/MapComparison.h"

#include <algorithm>
#include <cmath>

#include "analysis/Maps.h"
#include "plots/MapFigure.h"
#include "plots/UnitText.h"

namespace squat::plots {
namespace {

constexpr double shownBefore = 0.1, shownAfter = 0.28;  // [m]
constexpr double around = 1;                            // [m] beyond what is shown, for waves of 50 Hz
constexpr double faint = 1e-3;                          // of the largest power
constexpr double shownDecibels = 20;                    // to each side

// The stretch that is shown and what its transforms need around it.
signals::TimeSeries seriesOf(const signals::Comparison& c, const std::vector<double>& values, double speed) {
  const double perUnit = c.inPosition ? 1 / speed : 1;
  signals::TimeSeries series;
  series.start = c.axis.front() * perUnit;
  series.step = (c.axis.back() - c.axis.front()) * perUnit / static_cast<double>(c.axis.size() - 1);
  series.values = values;
  series.unit = c.unit;
  return signals::cutOut(series, -(shownBefore + around) / speed, (shownAfter + around) / speed);
}

// Both transforms have the grid of the common axis.
results::AnalysedRecord mapOf(const signals::TimeSeries& series, MapKind kind, double speed) {
  results::AnalysedRecord map;
  map.complete = true;
  map.speed = speed;
  map.psdFrom = std::max(-shownBefore, series.start * speed);
  map.psdTo = std::min(shownAfter, series.timeAt(series.values.size() - 1) * speed);
  std::vector<std::string> notes;
  if (kind == MapKind::scalogram) {
    signals::WaveletOptions options;
    options.cell = 0;
    options.shown = std::pair{map.psdFrom / speed, map.psdTo / speed};
    auto scalogram = analysis::scalogramMap(series, options, notes);
    map.scalogramFrequency = std::move(scalogram.frequency);
    map.scalogramTime = std::move(scalogram.time);
    map.scalogramPower = std::move(scalogram.power);
    map.coneOfInfluence = std::move(scalogram.coneOfInfluence);
  } else if (const auto stft = analysis::stftMap(series, {.segment = 0, .hop = 0}, notes)) {
    // Row 0 is the mean, which has no place on a logarithmic axis.
    map.scalogramFrequency.assign(stft->frequency.begin() + 1, stft->frequency.end());
    map.scalogramTime = stft->time;
    map.scalogramPower.assign(stft->density.begin() + static_cast<std::ptrdiff_t>(stft->time.size()),
                              stft->density.end());
  }
  for (const double time : map.scalogramTime) map.scalogramPosition.push_back(time * speed);
  map.position = map.scalogramPosition;
  return map;
}

double largestIn(const results::AnalysedRecord& map) {
  const auto& power = map.scalogramPower;
  return power.empty() ? 0 : *std::max_element(power.begin(), power.end());
}

results::AnalysedRecord ratioOf(const results::AnalysedRecord& first, const results::AnalysedRecord& second,
                                double floor) {
  results::AnalysedRecord ratio = first;
  for (std::size_t i = 0; i < ratio.scalogramPower.size(); ++i)
    ratio.scalogramPower[i] = 10 * std::log10((first.scalogramPower[i] + floor) / (second.scalogramPower[i] + floor));
  return ratio;
}

}  // namespace

FigureSheet mapComparison(const signals::Comparison& c, MapKind kind, const std::string& name, const Style& style) {
  FigureSheet sheet{name, {}, 2};
  const double speed = std::max(1e-3, c.firstFeatures.speed);
  const auto first = mapOf(seriesOf(c, c.first, speed), kind, speed);
  const auto second = mapOf(seriesOf(c, c.second, speed), kind, speed);
  const double largest = std::max(largestIn(first), largestIn(second));
  const QString power = kind == MapKind::scalogram ? QStringLiteral("Wavelet power [(%1)² s]")
                                                   : QStringLiteral("Power density [(%1)²/Hz]");
  const auto add = [&](const results::AnalysedRecord& map, const MapLook& look, const QString& left,
                       const QString& right) {
    auto figure = mapFigure(map, style, look);
    figure->xAxis->setLabel("Position relative to the impact [mm]");
    figure->setCaption(left, right);
    sheet.panels.push_back(std::move(figure));
  };
  const MapLook both{"first", power.arg(unitText(c.unit)), 0, largest, false};
  add(first, both, "(a) " + QString::fromStdString(c.firstName), QString());
  add(second, both, "(b) " + QString::fromStdString(c.secondName), QString());
  add(ratioOf(first, second, faint * largest), {"ratio", "(a) / (b) [dB]", -shownDecibels, shownDecibels, true},
      "(c) difference", "white: alike, or faint in both");
  return sheet;
}

}  // namespace squat::plots
