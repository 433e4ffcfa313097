#include "signals/Comparison.h"

#include <algorithm>
#include <cmath>

#include "signals/Resample.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

// Both on the axis of the first, without any shift: for runs that share their position (or their time). Positions are
// put on equal steps, which spectra need.
AlignedRuns overlay(const Passage& first, const Passage& second, bool inPosition, double anchor) {
  AlignedRuns result;
  result.inPosition = inPosition;
  result.values.resize(2);
  const Interpolator own(first.series), at(second.series);
  const double end = second.series.timeAt(second.series.values.size() - 1);
  const std::size_t count = first.series.values.size();
  const double step = (first.position.back() - first.position.front()) / static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = inPosition ? first.position.front() + step * static_cast<double>(i) : first.series.timeAt(i);
    const bool inside =
        inPosition ? x >= second.position.front() && x <= second.position.back() : x >= second.series.start && x <= end;
    if (!inside) continue;
    result.axis.push_back(x);
    result.values[0].push_back(inPosition ? own(timeAtPosition(first, x)) : first.series.values[i]);
    result.values[1].push_back(at(inPosition ? timeAtPosition(second, x) : x));
  }
  if (result.axis.size() < 32)
    throw SignalError("signals '" + first.series.name + "' and '" + second.series.name + "' do not overlap");
  const double anchored = inPosition ? positionAtTime(first, anchor) : anchor;
  const double impact = *std::min_element(result.axis.begin(), result.axis.end(), [&](double a, double b) {
    return std::abs(a - anchored) < std::abs(b - anchored);
  });
  for (double& x : result.axis) x -= impact;
  result.impact = {impact, impact};
  return result;
}

bool isSame(const Passage& first, const Passage& second) {
  return first.series.start == second.series.start && first.series.step == second.series.step &&
         first.series.values == second.series.values && first.position == second.position;
}

double ratio(double a, double b) { return b != 0 ? a / b : 0.0; }

double rmsOf(const std::vector<double>& values) { return movingRms(values, 2 * values.size()).front(); }

double peakOf(const std::vector<double>& values) {
  double peak = 0;
  for (const double value : values) peak = std::max(peak, std::abs(value));
  return peak;
}

std::vector<PeakPair> pairPeaks(const std::vector<SpectralPeak>& first, const std::vector<SpectralPeak>& second,
                                double search) {
  std::vector<PeakPair> pairs;
  for (const auto& peak : first) {
    const SpectralPeak* nearest = nullptr;
    for (const auto& other : second)
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
  const Anchor anchor = options.features.anchor.value_or(anchorOf(first));
  AlignmentOptions alignment{options.features.before, options.features.after, options.largestShift, anchor.time};
  AlignedRuns runs = !options.align       ? overlay(first, second, options.inPosition, anchor.time)
                     : options.inPosition ? alignInPosition({first, second}, alignment)
                                          : alignInTime({first, second}, alignment);
  if (isSame(first, second))  // what the interpolation of a shift of zero costs is no difference
    runs.values[1] = runs.values[0], runs.impact[1] = runs.impact[0];
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

  // Features are those that each signal has on its own, at its own speed: the same numbers as in an analysis.
  const auto timeOf = [&](const Passage& passage, double impact) {
    return runs.inPosition ? timeAtPosition(passage, impact) : impact;
  };
  const double firstTime = timeOf(first, runs.impact[0]), secondTime = timeOf(second, runs.impact[1]);
  FeatureOptions features = options.features;
  features.anchor = anchor;
  features = anchored(first, features);
  result.firstFeatures = signals::features(first.series, features);
  FeatureOptions ofSecond = features;
  ofSecond.anchor = Anchor{secondTime + anchor.time - firstTime, AnchorRule::aligned};
  result.secondFeatures = signals::features(second, ofSecond);

  // What is compared lies on one axis; places are divided by the first's speed, so that frequencies stay comparable.
  const double perAxis = runs.inPosition ? 1 / features.speed : 1.0;
  const double step = (runs.axis[1] - runs.axis[0]) * perAxis;
  const TimeSeries one{runs.axis.front() * perAxis, step, result.first, first.series.name, first.series.unit};
  const TimeSeries other{runs.axis.front() * perAxis, step, result.second, second.series.name, second.series.unit};
  const double from = -features.before / features.speed, to = features.after / features.speed;
  result.firstSpectrum = localSpectrum(one, from, to);
  result.secondSpectrum = localSpectrum(other, from, to);
  // What the slower record cannot hold has no ratio: its share there is what the interpolation leaks.
  const double secondRate =
      second.series.rate() * (runs.inPosition ? speedAt(second, secondTime) / features.speed : 1.0);
  const double rate = std::min(first.series.rate(), secondRate);
  for (std::size_t k = 0; k < result.firstSpectrum.density.size(); ++k)
    result.densityRatio.push_back(result.firstSpectrum.frequency[k] < rate / 2
                                      ? ratio(result.firstSpectrum.density[k], result.secondSpectrum.density[k])
                                      : NAN);

  const auto firstPart = cutOut(one, from, to).values, secondPart = cutOut(other, from, to).values;
  result.correlation = correlationOf(firstPart, secondPart);
  result.peakRatio = ratio(peakOf(firstPart), peakOf(secondPart));
  result.rmsRatio = ratio(rmsOf(firstPart), rmsOf(secondPart));
  result.differencePeak = peakOf(result.difference);
  result.differenceRms = rmsOf(result.difference);
  for (std::size_t b = 0; b < features.bands.size(); ++b) {
    result.bands.push_back(features.bands[b]);
    result.bandRatio.push_back(
        shows(rate, features.bands[b])
            ? ratio(bandPower(result.firstSpectrum, features.bands[b].low, features.bands[b].high),
                    bandPower(result.secondSpectrum, features.bands[b].low, features.bands[b].high))
            : NAN);
  }
  const auto linesOf = [&](const PowerSpectrum& spectrum) {
    return spectralPeaks(spectrum, features.lowestPeak, features.highestPeak, features.peakShare);
  };
  result.peaks = pairPeaks(linesOf(result.firstSpectrum), linesOf(result.secondSpectrum), options.peakSearch);
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
  for (std::size_t p = 0; p < 4; ++p) {
    const PeakPair pair = p < c.peaks.size() ? c.peaks[p] : PeakPair{NAN, NAN};
    row.emplace_back("line " + std::to_string(p + 1) + " first [Hz]", pair.first);
    row.emplace_back("line " + std::to_string(p + 1) + " second [Hz]", pair.second);
    row.emplace_back("line " + std::to_string(p + 1) + " shift [Hz]", pair.shift());
  }
  return row;
}

}  // namespace squat::signals
