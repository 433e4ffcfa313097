#include "statements/Measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "analysis/RunFeatures.h"
#include "signals/BandDecay.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "statements/RunChecks.h"

namespace squat::statements {

namespace {

using results::RunResult;
using Measure = std::function<std::optional<double>(const RunResult&, const Statement&)>;

std::string channelOf(const Statement& statement) {
  return statement.point == wheelCentre ? signals::names::wheelFiltered : signals::names::axleBoxFiltered;
}

bool judgesLowLines(const Statement& statement) {
  constexpr double low = 320;  // [Hz]
  return (statement.near > 0 && statement.near <= low) || (statement.band.second > 0 && statement.band.second <= low);
}

signals::FeatureOptions optionsFor(const RunResult& result, const Statement& statement) {
  constexpr double longWay = 0.58, margin = 0.02;  // [m]
  signals::FeatureOptions options;
  if (statement.band.second > 0) options.bands = {{"band", statement.band.first, statement.band.second}};
  if (judgesLowLines(statement) && !result.position.empty())
    options.after = std::clamp(result.position.back() - margin, options.after, longWay);
  return options;
}

signals::Features featuresOf(const RunResult& result, const Statement& statement) {
  return analysis::runFeatures(result, optionsFor(result, statement), channelOf(statement));
}

std::optional<double> positive(double value) { return value > 0 ? std::optional(value) : std::nullopt; }

std::optional<double> maximum(const RunResult& result, const Statement& statement) {
  const auto* aba = result.signal(channelOf(statement));
  if (!aba || aba->empty()) return std::nullopt;
  return *std::max_element(aba->begin(), aba->end());
}

std::optional<double> elements(const RunResult& result, const Statement&) {
  for (const auto& figure : result.meshFigures)
    if (figure.name == "elements") return figure.value;
  return std::nullopt;
}

std::optional<double> wavelength(const RunResult& result, const Statement& statement) {
  return positive(1e3 * featuresOf(result, statement).wavelengthByRidge);
}

std::optional<double> waveFrequency(const RunResult& result, const Statement& statement) {
  const auto length = wavelength(result, statement);
  return length ? std::optional(result.speed / (1e-3 * *length)) : std::nullopt;
}

std::optional<double> line(const RunResult& result, const Statement& statement) {
  const auto lines = strongLines(result, statement);
  if (!lines) return std::nullopt;
  const auto distance = [&](double frequency) { return std::abs(std::log(frequency / statement.near)); };
  const auto& all = lines->frequencies;
  const auto nearest =
      std::min_element(all.begin(), all.end(), [&](double a, double b) { return distance(a) < distance(b); });
  return nearest == all.end() ? std::nullopt : std::optional(*nearest);
}

std::optional<double> linesWithin(const RunResult& result, const Statement& statement) {
  const auto lines = signals::spectralPeaks(featuresOf(result, statement).spectrum, 50, 2000, 0.01);
  return static_cast<double>(std::count_if(lines.begin(), lines.end(), [&](const auto& peak) {
    return peak.frequency >= statement.band.first && peak.frequency <= statement.band.second;
  }));
}

std::optional<double> bandPower(const RunResult& result, const Statement& statement) {
  return featuresOf(result, statement).bands.at(0).power;
}
std::optional<double> bandShare(const RunResult& result, const Statement& statement) {
  return featuresOf(result, statement).bands.at(0).share;
}
std::optional<double> freeVibration(const RunResult& result, const Statement& statement) {
  const auto* values = result.signal(channelOf(statement));
  if (!values || values->size() != result.time.size() || values->size() < 2) return std::nullopt;
  const signals::TimeSeries series{result.time.front(),
                                   (result.time.back() - result.time.front()) / static_cast<double>(values->size() - 1),
                                   *values, statement.point, "m/s2"};
  const double impact = featuresOf(result, statement).impactTime;
  const signals::Band band{"band", statement.band.first, statement.band.second};
  // Half the filter's own ringing before the impact belongs to it.
  const double ahead = 0.5 / (band.high - band.low);
  const auto decay = signals::bandDecay(series, impact - ahead, result.time.back(), band);
  if (decay.ratio() >= statement.low && (decay.frequency < band.low || decay.frequency > band.high)) return 0;
  // A record that ends while the band still rings can show that it rings long, not that it does not.
  if (!decay.ended && decay.ratio() < statement.low) return std::nullopt;
  return decay.ratio();
}

// The result's own scalogram is that of the axle box.
std::optional<double> impactTop(const RunResult& result, const Statement& statement) {
  const auto columns = result.scalogramTime.size();
  const auto& power = result.scalogramPower;
  if (statement.point != axleBox) return std::nullopt;
  if (power.empty() || power.size() != result.scalogramFrequency.size() * columns) return std::nullopt;
  if (result.scalogramPosition.size() != columns) return std::nullopt;
  const double minimum = 0.05 * *std::max_element(power.begin(), power.end());
  double top = 0;
  for (std::size_t row = 0; row < result.scalogramFrequency.size(); ++row)
    for (std::size_t column = 0; column < columns; ++column)
      if (std::abs(result.scalogramPosition[column]) <= 0.01 && power[row * columns + column] >= minimum)
        top = std::max(top, result.scalogramFrequency[row]);
  return positive(top);
}

std::optional<double> largestVibration(const RunResult& result, const Statement& statement) {
  const auto seen = residualVibration(result, channelOf(statement));
  return seen ? std::optional(seen->largest) : std::nullopt;
}

struct NamedMeasure {
  const char* unit;
  Measure measure;
};

const std::map<std::string, NamedMeasure>& measures() {
  static const std::map<std::string, NamedMeasure> table = {{"band_power", {"(m/s2)2", bandPower}},
                                                            {"band_share", {"1", bandShare}},
                                                            {"elements", {"1", elements}},
                                                            {"free_vibration", {"1", freeVibration}},
                                                            {"impact_top", {"Hz", impactTop}},
                                                            {"line", {"Hz", line}},
                                                            {"lines_within", {"1", linesWithin}},
                                                            {"maximum", {"m/s2", maximum}},
                                                            {"residual_vibration", {"m/s2", largestVibration}},
                                                            {"wave_frequency", {"Hz", waveFrequency}},
                                                            {"wavelength", {"mm", wavelength}}};
  return table;
}

}  // namespace

std::vector<std::string> measureNames() {
  std::vector<std::string> names;
  for (const auto& [name, row] : measures()) names.push_back(name);
  return names;
}

std::string unitOfMeasure(const std::string& name) {
  const auto found = measures().find(name);
  return found == measures().end() ? std::string() : found->second.unit;
}

std::optional<Lines> strongLines(const RunResult& result, const Statement& statement) {
  constexpr double lowest = 50, highest = 2000, share = 0.05;
  try {
    const auto features = featuresOf(result, statement);
    Lines lines;
    for (const auto& peak : signals::spectralPeaks(features.spectrum, lowest, highest, share))
      lines.frequencies.push_back(peak.frequency);
    const auto rate = static_cast<double>(result.time.size() - 1) / (result.time.back() - result.time.front());
    // Hann's main lobe is four steps of 1/T wide: lines nearer than half of that are one.
    lines.resolution = 2 * rate / static_cast<double>(features.spectrum.segmentLength);
    return lines;
  } catch (const signals::SignalError&) {  // too short, constant
    return std::nullopt;
  }
}

std::optional<double> measure(const RunResult& result, const Statement& statement) {
  const auto found = measures().find(statement.measure);
  if (found == measures().end()) return std::nullopt;
  try {
    return found->second.measure(result, statement);
  } catch (const signals::SignalError&) {  // too short, constant: nothing to judge
    return std::nullopt;
  }
}

}  // namespace squat::statements
