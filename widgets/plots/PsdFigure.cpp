#include <algorithm>
#include <cmath>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"

namespace squat::plots {
namespace {

constexpr double shownUpTo = 2500;         // [Hz] a little beyond the filter's cut-off
constexpr double leastShareOfPeak = 0.04;  // peaks below this share of the highest are not labelled
constexpr std::size_t mostLabels = 5;
constexpr double leastDistance = 190;  // [Hz] between labels, so that they do not touch at one column

struct Peak {
  double frequency = 0, power = 0;
};

std::vector<Peak> strongestPeaks(const std::vector<double>& frequency, const std::vector<double>& power) {
  std::vector<Peak> peaks;
  for (std::size_t i = 1; i + 1 < std::min(frequency.size(), power.size()); ++i)
    if (power[i] > power[i - 1] && power[i] >= power[i + 1] && frequency[i] < shownUpTo)
      peaks.push_back({frequency[i], power[i]});
  std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.power > b.power; });
  std::vector<Peak> kept;
  for (const Peak& peak : peaks) {
    if (kept.size() == mostLabels || peak.power < leastShareOfPeak * peaks.front().power) break;
    const bool apart = std::all_of(kept.begin(), kept.end(), [&](const Peak& other) {
      return std::abs(other.frequency - peak.frequency) >= leastDistance;
    });
    if (apart) kept.push_back(peak);
  }
  return kept;
}

}  // namespace

std::unique_ptr<Figure> psdFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("psd", style);
  figure->xAxis->setLabel("Frequency [Hz]");
  figure->yAxis->setLabel("PSD [(m/s²)²/Hz]");
  if (result.frequency.size() < 2 || result.psd.size() != result.frequency.size())
    addNotice(*figure, "no spectrum in this result");
  addCurve(*figure, {result.frequency, result.psd, result.psdWheel.empty() ? QString() : QString("axle box"), 0, 1.2,
                     Qt::SolidLine, true});
  if (result.psdWheel.size() == result.frequency.size() && !result.psdWheel.empty())
    addCurve(*figure, {result.frequency, result.psdWheel, "wheel centre", 1, 0.8});
  const double top = result.frequency.empty() ? shownUpTo : std::min(shownUpTo, result.frequency.back());
  figure->xAxis->setRange(0, std::max(top, 1.0));
  fitValues(*figure);
  figure->yAxis->setRange(0, 1.12 * figure->yAxis->range().upper);
  for (const Peak& peak : strongestPeaks(result.frequency, result.psd))
    addPointLabel(*figure, peak.frequency, peak.power, QString::number(peak.frequency, 'f', 0));
  setCaption(*figure, result);
  return figure;
}

}  // namespace squat::plots
