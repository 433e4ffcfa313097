#include "validation/Measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "laboratory/RunFeatures.h"
#include "signals/SignalError.h"

namespace squat::validation {

namespace {

using results::RunResult;
using Measure = std::function<std::optional<double>(const RunResult&, const Statement&)>;

signals::Features featuresOf(const RunResult& result, const Statement& statement) {
  signals::FeatureOptions options;
  if (statement.band.second > 0) options.bands = {{"band", statement.band.first, statement.band.second}};
  return laboratory::runFeatures(result, options);
}

std::optional<double> positive(double value) { return value > 0 ? std::optional(value) : std::nullopt; }

std::optional<double> maximum(const RunResult& result, const Statement&) {
  const auto* aba = result.signal("aba_filtered");
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
  const auto lines = signals::spectralPeaks(featuresOf(result, statement).spectrum, 50, 2000, 0.05);
  const auto distance = [&](const auto& peak) { return std::abs(std::log(peak.frequency / statement.near)); };
  const auto nearest = std::min_element(lines.begin(), lines.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return nearest == lines.end() ? std::nullopt : std::optional(nearest->frequency);
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
  return 1e3 * featuresOf(result, statement).bands.at(0).freeVibration;
}

std::optional<double> impactTop(const RunResult& result, const Statement&) {
  const auto columns = result.scalogramTime.size();
  const auto& power = result.scalogramPower;
  if (columns == 0 || power.size() != result.scalogramFrequency.size() * columns) return std::nullopt;
  if (result.scalogramPosition.size() != columns) return std::nullopt;
  const double least = 0.05 * *std::max_element(power.begin(), power.end());
  double top = 0;
  for (std::size_t row = 0; row < result.scalogramFrequency.size(); ++row)
    for (std::size_t column = 0; column < columns; ++column)
      if (std::abs(result.scalogramPosition[column]) <= 0.01 && power[row * columns + column] >= least)
        top = std::max(top, result.scalogramFrequency[row]);
  return positive(top);
}

std::optional<double> quiet(const RunResult& result, const Statement&) {
  const auto* aba = result.signal("aba_filtered");
  if (!aba || aba->size() != result.position.size()) return std::nullopt;
  std::vector<double> window;
  for (std::size_t i = 0; i < aba->size(); ++i)
    if (result.position[i] >= -0.24 && result.position[i] <= -0.04) window.push_back((*aba)[i]);
  if (window.size() < 2) return std::nullopt;
  double mean = 0, largest = 0;
  for (const double value : window) mean += value / static_cast<double>(window.size());
  for (const double value : window) largest = std::max(largest, std::abs(value - mean));
  return largest;
}

const std::map<std::string, Measure>& measures() {
  static const std::map<std::string, Measure> table = {
      {"band_power", bandPower},         {"band_share", bandShare}, {"elements", elements},
      {"free_vibration", freeVibration}, {"impact_top", impactTop}, {"line", line},
      {"lines_within", linesWithin},     {"maximum", maximum},      {"quiet", quiet},
      {"wave_frequency", waveFrequency}, {"wavelength", wavelength}};
  return table;
}

}  // namespace

std::vector<std::string> measureNames() {
  std::vector<std::string> names;
  for (const auto& [name, function] : measures()) names.push_back(name);
  return names;
}

std::optional<double> measure(const RunResult& result, const Statement& statement) {
  const auto found = measures().find(statement.measure);
  if (found == measures().end()) return std::nullopt;
  try {
    return found->second(result, statement);
  } catch (const signals::SignalError&) {  // too short, constant: nothing to judge
    return std::nullopt;
  }
}

}  // namespace squat::validation
