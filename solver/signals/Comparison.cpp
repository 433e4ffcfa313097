#include "signals/Comparison.h"

#include <algorithm>
#include <cmath>

#include "signals/Resample.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

// Both on the axis of the first, without any shift: for runs that share their position (or their time). Positions are
// put on equal steps, which spectra need.
AlignedRuns overlay(const Passage& first, const Passage& second, bool inPosition) {
  AlignedRuns result;
  result.inPosition = inPosition;
  result.values.resize(2);
  const Interpolator own(first.series), at(second.series);
  const double end = second.series.timeAt(second.series.values.size() - 1);
  const std::size_t count = first.series.values.size();
  const double step = (first.position.back() - first.position.front()) / static_cast<double>(count - 1);
  std::size_t largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = inPosition ? first.position.front() + step * static_cast<double>(i) : first.series.timeAt(i);
    const bool inside = inPosition ? place >= second.position.front() && place <= second.position.back()
                                   : place >= second.series.start && place <= end;
    if (!inside) continue;
    result.axis.push_back(place);
    result.values[0].push_back(inPosition ? own(timeAtPosition(first, place)) : first.series.values[i]);
    result.values[1].push_back(at(inPosition ? timeAtPosition(second, place) : place));
    if (std::abs(result.values[0].back()) > std::abs(result.values[0][largest])) largest = result.axis.size() - 1;
  }
  if (result.axis.size() < 32)
    throw SignalError("signals '" + first.series.name + "' and '" + second.series.name +
                      "' have no length in common on their axes");
  const double impact = result.axis[largest];
  for (double& x : result.axis) x -= impact;
  result.impact = {impact, impact};
  return result;
}

double ratio(double a, double b) { return b != 0 ? a / b : 0.0; }

double rmsOf(const std::vector<double>& values) { return movingRms(values, 2 * values.size()).front(); }

double peakOf(const std::vector<double>& values) {
  double peak = 0;
  for (const double value : values) peak = std::max(peak, std::abs(value));
  return peak;
}

std::vector<PeakPair> pairPeaks(const Features& first, const Features& second, double search) {
  std::vector<PeakPair> pairs;
  for (const auto& peak : first.peaks) {
    const SpectralPeak* nearest = nullptr;
    for (const auto& other : second.peaks)
      if (std::abs(other.frequency - peak.frequency) <= search * peak.frequency &&
          (!nearest || other.prominence > nearest->prominence))
        nearest = &other;
    if (nearest) pairs.push_back({peak.frequency, nearest->frequency});
  }
  return pairs;
}

}  // namespace

Comparison compare(const Passage& first, const Passage& second, const ComparisonOptions& options) {
  for (const Passage* passage : {&first, &second}) {
    requireUsable(passage->series, 32, "a comparison");
    requireVarying(passage->series, "a comparison");
    requireRisingPositions(*passage);
  }
  if (first.series.unit != second.series.unit)
    throw SignalError("signals '" + first.series.name + "' and '" + second.series.name +
                      "' have different units: " + first.series.unit + " and " + second.series.unit);
  AlignmentOptions alignment{options.features.before, options.features.after, options.largestShift};
  const AlignedRuns runs = !options.align       ? overlay(first, second, options.inPosition)
                           : options.inPosition ? alignInPosition({first, second}, alignment)
                                                : alignInTime({first, second}, alignment);
  Comparison result;
  result.firstName = first.series.name;
  result.secondName = second.series.name;
  result.unit = first.series.unit;
  result.inPosition = runs.inPosition;
  result.axis = runs.axis;
  result.first = runs.values[0];
  result.second = runs.values[1];
  result.shift = runs.impact[1] - runs.impact[0];
  for (std::size_t i = 0; i < runs.axis.size(); ++i) result.difference.push_back(result.first[i] - result.second[i]);

  // Spectra and features over time; a position axis is divided by the first's speed, so wavelengths stay comparable.
  const auto firstImpact = std::min_element(runs.axis.begin(), runs.axis.end(),
                                            [](double a, double b) { return std::abs(a) < std::abs(b); });
  FeatureOptions features = options.features;
  const auto impactTimeOf = [&](const Passage& passage, double impact) {
    return runs.inPosition ? timeAtPosition(passage, impact) : impact;
  };
  features.speed = speedAt(first, impactTimeOf(first, runs.impact[0]));
  const double perAxis = runs.inPosition ? 1 / features.speed : 1.0;
  features.impactTime = *firstImpact * perAxis;
  const double step = (runs.axis[1] - runs.axis[0]) * perAxis;
  const TimeSeries one{runs.axis.front() * perAxis, step, result.first, first.series.name, first.series.unit};
  const TimeSeries other{runs.axis.front() * perAxis, step, result.second, second.series.name, second.series.unit};
  result.firstFeatures = signals::features(one, features);
  // Over time each passage has a speed of its own.
  FeatureOptions ofSecond = features;
  if (!runs.inPosition) ofSecond.speed = speedAt(second, runs.impact[1]);
  result.secondFeatures = signals::features(other, ofSecond);
  result.firstSpectrum = result.firstFeatures.spectrum;
  result.secondSpectrum = result.secondFeatures.spectrum;
  // What the slower record cannot hold has no ratio: its share there is what the interpolation leaks.
  const double secondRate =
      second.series.rate() *
      (runs.inPosition ? speedAt(second, impactTimeOf(second, runs.impact[1])) / features.speed : 1.0);
  const double rate = std::min(first.series.rate(), secondRate);
  for (std::size_t k = 0; k < result.firstSpectrum.density.size(); ++k)
    result.densityRatio.push_back(result.firstSpectrum.frequency[k] < rate / 2
                                      ? ratio(result.firstSpectrum.density[k], result.secondSpectrum.density[k])
                                      : NAN);

  const double from = *features.impactTime - features.before / features.speed;
  const double to = *features.impactTime + features.after / features.speed;
  const auto firstPart = cutOut(one, from, to).values, secondPart = cutOut(other, from, to).values;
  result.correlation = correlationOf(firstPart, secondPart);
  result.peakRatio = ratio(peakOf(firstPart), peakOf(secondPart));
  result.rmsRatio = ratio(rmsOf(firstPart), rmsOf(secondPart));
  result.differencePeak = peakOf(result.difference);
  result.differenceRms = rmsOf(result.difference);
  for (std::size_t b = 0; b < features.bands.size(); ++b) {
    result.bands.push_back(features.bands[b]);
    result.bandRatio.push_back(shows(rate, features.bands[b])
                                   ? ratio(result.firstFeatures.bands[b].power, result.secondFeatures.bands[b].power)
                                   : NAN);
  }
  result.peaks = pairPeaks(result.firstFeatures, result.secondFeatures, options.peakSearch);
  return result;
}

std::vector<std::pair<std::string, double>> comparisonRow(const Comparison& c) {
  const std::string unit = " [" + c.unit + "]";
  std::vector<std::pair<std::string, double>> row{{"peak ratio [-]", c.peakRatio},
                                                  {"rms ratio [-]", c.rmsRatio},
                                                  {"correlation [-]", c.correlation},
                                                  {c.inPosition ? "shift [m]" : "shift [s]", c.shift},
                                                  {"difference peak" + unit, c.differencePeak},
                                                  {"difference rms" + unit, c.differenceRms}};
  for (std::size_t b = 0; b < c.bands.size(); ++b)
    row.emplace_back("power ratio " + c.bands[b].name + " [-]", c.bandRatio[b]);
  for (std::size_t p = 0; p < std::min<std::size_t>(4, c.peaks.size()); ++p) {
    row.emplace_back("line " + std::to_string(p + 1) + " first [Hz]", c.peaks[p].first);
    row.emplace_back("line " + std::to_string(p + 1) + " second [Hz]", c.peaks[p].second);
    row.emplace_back("line " + std::to_string(p + 1) + " shift [Hz]", c.peaks[p].shift());
  }
  return row;
}

}  // namespace squat::signals
