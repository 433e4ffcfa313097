#include "studio/SignalSettings.h"

#include <algorithm>
#include <cmath>

#include "signals/Butterworth.h"
#include "signals/ContinuousWavelet.h"
#include "signals/PowerSpectrum.h"
#include "signals/Resample.h"
#include "signals/SignalError.h"

namespace squat::studio {
namespace {

results::Channel* channel(results::RunResult& result, const std::string& name) {
  for (auto& each : result.signals)
    if (each.name == name) return &each;
  return nullptr;
}

void filter(results::RunResult& result, const std::string& raw, const std::string& filtered, double cutoff) {
  const auto* values = result.signal(raw);
  results::Channel* target = channel(result, filtered);
  if (!values || !target || values->size() != result.time.size() || values->size() < 2) return;
  const signals::TimeSeries series{result.time.front(), result.time[1] - result.time[0], *values, raw, "m/s2"};
  target->values = signals::lowPass(series, cutoff).values;
}

// In the unit that the user types.
std::string millimetres(double metres) { return std::to_string(std::lround(1e3 * metres)) + " mm"; }

void requireSamples(const results::RunResult& result, double from, double to) {
  const auto within = std::count_if(result.position.begin(), result.position.end(),
                                    [&](double position) { return position >= from && position <= to; });
  constexpr int fewest = 2;
  if (within >= fewest) return;
  throw signals::SignalError("the section from " + millimetres(from) + " to " + millimetres(to) +
                             " lies outside the record, which extends from " + millimetres(result.position.front()) +
                             " to " + millimetres(result.position.back()));
}

std::vector<double> spectrum(results::RunResult& result, const std::string& name, const SignalSettings& settings) {
  const auto* values = result.signal(name);
  if (!values || values->size() != result.time.size() || values->size() < 2) return {};
  const signals::TimeSeries series{result.time.front(), result.time[1] - result.time[0], *values, name, "m/s2"};
  requireSamples(result, settings.from, settings.to);
  const double from = signals::interpolateLinear(result.position, result.time, settings.from);
  const double to = signals::interpolateLinear(result.position, result.time, settings.to);
  signals::PowerSpectrumOptions options;
  options.window = signals::windowFromText(settings.window);
  const signals::TimeSeries part = signals::cutOut(series, from, to);
  constexpr std::size_t padding = 4;  // a smooth curve; the resolution stays that of the stretch
  options.transformLength = padding * part.values.size();
  signals::PowerSpectrum density = signals::powerSpectrum(part, options);
  result.frequency = std::move(density.frequency);
  return std::move(density.density);
}

// The stretch that the other figures show (psdFrom, psdTo) stays that of the run.
void takeSpectra(results::RunResult& result, const SignalSettings& settings) {
  auto before = result.frequency;
  const auto wheel = spectrum(result, "wheel_acceleration_filtered", settings);
  auto box = spectrum(result, "aba_filtered", settings);
  if (box.empty()) {
    result.frequency = std::move(before);  // that of the spectrum that stays
    return;
  }
  result.psd = std::move(box);
  result.psdWheel = wheel.size() == result.psd.size() ? wheel : std::vector<double>();
  result.psdWindow = settings.window;
}

}  // namespace

std::shared_ptr<const results::RunResult> analysed(const results::RunResult& result, const SignalSettings& settings,
                                                   std::string& problem) {
  auto changed = std::make_shared<results::RunResult>(result);
  problem.clear();
  try {
    filter(*changed, "aba", "aba_filtered", settings.cutoff);
    filter(*changed, "wheel_acceleration", "wheel_acceleration_filtered", settings.cutoff);
  } catch (const signals::SignalError& error) {
    problem = error.what();
    return std::make_shared<const results::RunResult>(result);
  }
  try {
    takeSpectra(*changed, settings);
  } catch (const signals::SignalError& error) {  // the filtered signals are none the worse for it
    problem = std::string("Spectrum not updated: ") + error.what();
    changed->frequency = result.frequency;
  }
  return changed;
}

std::shared_ptr<const results::RunResult> withScalogram(const results::RunResult& result) {
  auto changed = std::make_shared<results::RunResult>(result);
  const auto* values = changed->signal("aba_filtered");
  if (!values || values->size() != changed->time.size() || changed->position.size() != changed->time.size() ||
      values->size() < 64)
    return changed;
  const signals::TimeSeries series{changed->time.front(), changed->time[1] - changed->time[0], *values, "", "m/s2"};
  signals::WaveletOptions options;  // as runs have it: up to 2500 Hz, 16 voices an octave
  options.highest = std::min(options.highest, 0.45 * series.rate());
  constexpr std::size_t mostColumns = 2000;  // more than a screen has
  options.cell = 1 + values->size() / mostColumns;
  try {
    signals::Scalogram anew = signals::scalogram(series, options);
    changed->scalogramFrequency = std::move(anew.frequency);
    changed->scalogramTime = std::move(anew.time);
    changed->scalogramPower = std::move(anew.power);
    changed->coneOfInfluence = std::move(anew.coneOfInfluence);
    changed->scalogramPosition.clear();
    for (const double time : changed->scalogramTime)
      changed->scalogramPosition.push_back(signals::interpolateLinear(changed->time, changed->position, time));
  } catch (const signals::SignalError&) {
    // What was there stays.
  }
  return changed;
}

}  // namespace squat::studio
