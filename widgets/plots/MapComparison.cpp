#include "plots/MapComparison.h"

#include <algorithm>
#include <cmath>

#include "analysis/Maps.h"
#include "plots/MapFigure.h"
#include "plots/ScalogramGrid.h"
#include "plots/ShownStretch.h"
#include "plots/UnitText.h"

namespace squat::plots {
namespace {

constexpr double lowestFrequency = 50, highestFrequency = 3000;  // [Hz] that maps show
constexpr double around = 1;                                     // [m] beyond what is shown, for waves of 50 Hz
constexpr double faint = 1e-3;                                   // of the largest power
constexpr double ratioDecibels = 20;                             // to each side

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

// Over the axis of the comparison, [m] or [s]; the transforms of both signals have one grid.
results::AnalysedRecord mapOf(const signals::Comparison& c, const std::vector<double>& values, MapKind kind,
                              double speed) {
  const auto series = seriesOf(c, values, speed);
  const double perSecond = c.inPosition ? speed : 1;  // of the axis
  results::AnalysedRecord map;
  map.complete = true;
  const double from = std::max(-shownBefore / speed, series.start),
               to = std::min(shownAfter / speed, series.timeAt(series.values.size() - 1));
  map.psdFrom = from * perSecond;
  map.psdTo = to * perSecond;
  std::vector<std::string> notes;
  if (kind == MapKind::scalogram) {
    signals::WaveletOptions options;
    options.cell = 0;
    options.shown = std::pair{from, to};
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
  for (const double time : map.scalogramTime) map.scalogramPosition.push_back(time * perSecond);
  map.position = map.scalogramPosition;
  return map;
}

// Of what is seen: a strike beside it neither dims the colours nor hides what is faint.
double largestSeen(const results::AnalysedRecord& map) {
  return scalogramGrid(map, map.psdFrom, map.psdTo, lowestFrequency, highestFrequency).largestPower;
}

// [Hz] up to which both signals can have power: half the lower rate.
double commonFrequency(const signals::Comparison& c) {
  const auto& ratio = c.densityRatio;
  const auto beyond = std::find_if(ratio.begin(), ratio.end(), [](double value) { return std::isnan(value); });
  return beyond == ratio.end() ? highestFrequency
                               : c.firstSpectrum.frequency[static_cast<std::size_t>(beyond - ratio.begin())];
}

results::AnalysedRecord ratioOf(const results::AnalysedRecord& first, const results::AnalysedRecord& second,
                                double floor, double upTo) {
  results::AnalysedRecord ratio = first;
  const std::size_t columns = first.scalogramTime.size();
  for (std::size_t i = 0; i < ratio.scalogramPower.size(); ++i)
    ratio.scalogramPower[i] =
        first.scalogramFrequency[i / columns] > upTo
            ? 0
            : 10 * std::log10((first.scalogramPower[i] + floor) / (second.scalogramPower[i] + floor));
  return ratio;
}

}  // namespace

FigureSheet mapComparison(const signals::Comparison& c, MapKind kind, const std::string& name, const Style& style) {
  FigureSheet sheet{name, {}, 2};
  const double speed = std::max(1e-3, c.firstFeatures.speed);
  const auto first = mapOf(c, c.first, kind, speed), second = mapOf(c, c.second, kind, speed);
  const double largest = std::max(largestSeen(first), largestSeen(second));
  const QString power = kind == MapKind::scalogram ? QStringLiteral("Wavelet power [(%1)² s]")
                                                   : QStringLiteral("Power density [(%1)²/Hz]");
  const auto add = [&](const results::AnalysedRecord& map, const MapLook& look, const QString& left,
                       const QString& right) {
    auto figure = mapFigure(map, style, look);
    figure->xAxis->setLabel(c.inPosition ? "Position relative to the impact [mm]" : "Time relative to the impact [ms]");
    figure->setCaption(left, right);
    sheet.panels.push_back(std::move(figure));
  };
  const QString map = kind == MapKind::scalogram ? QStringLiteral("scalogram") : QStringLiteral("stft");
  const MapLook both{map, power.arg(unitText(c.unit)), 0, largest, false};
  add(first, both, "(a) " + QString::fromStdString(c.firstName), QString());
  add(second, both, "(b) " + QString::fromStdString(c.secondName), QString());
  add(ratioOf(first, second, faint * largest, commonFrequency(c)),
      {map, "(a) / (b) [dB]", -ratioDecibels, ratioDecibels, true}, "(c) ratio of (a) and (b)",
      "white: alike, or faint in both");
  return sheet;
}

}  // namespace squat::plots
