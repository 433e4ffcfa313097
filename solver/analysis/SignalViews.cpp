#include "analysis/SignalViews.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/Maps.h"
#include "signals/Butterworth.h"
#include "signals/Features.h"
#include "signals/Resample.h"
#include "signals/SignalError.h"

namespace squat::analysis {
namespace {

void filter(signals::Record& record, const char* raw, const char* filtered, double cutoff) {
  signals::Channel* target = record.channel(filtered);
  if (!record.channel(raw) || !target || record.time.size() < 2) return;
  target->values = signals::lowPass(signals::seriesOf(record, raw), cutoff).values;
}

// In the unit that the user types.
std::string millimetres(double metres) { return std::to_string(std::lround(1e3 * metres)) + " mm"; }

void requireSamples(const signals::Record& record, double from, double to) {
  const auto& x = record.position;
  const auto within =
      std::count_if(x.begin(), x.end(), [&](double position) { return position >= from && position <= to; });
  constexpr int fewest = 2;
  if (within >= fewest || x.empty()) return;
  throw signals::SignalError("the section from " + millimetres(from) + " to " + millimetres(to) +
                             " lies outside the record, which extends from " + millimetres(x.front()) + " to " +
                             millimetres(x.back()));
}

}  // namespace

void filterPartners(signals::Record& record, double cutoff) {
  for (const auto& row : signals::signalCatalogue())
    if (row.filteredName) filter(record, row.name, row.filteredName, cutoff);
}

signals::PowerSpectrum sectionSpectrum(const signals::Record& record, const Section& section, const std::string& window,
                                       const std::string& channel) {
  requireSamples(record, section.from, section.to);
  return signals::stretchSpectrum(signals::passageOf(record, channel), section.from, section.to,
                                  signals::windowFromText(window));
}

std::shared_ptr<const results::RunResult> resultThrough(const FigureSettings& settings,
                                                        const results::RunResult& result, std::string& problem) {
  auto changed = std::make_shared<results::RunResult>(result);
  problem.clear();
  try {
    filterPartners(*changed, settings.cutoff);
  } catch (const signals::SignalError& error) {
    problem = error.what();
    return std::make_shared<const results::RunResult>(result);
  }
  if (!changed->channel(signals::names::axleBoxFiltered) || changed->time.size() < 2) return changed;
  try {
    const Section section = settings.section.value_or(Section{result.psdFrom, result.psdTo});
    auto box = sectionSpectrum(*changed, section, settings.window);
    std::vector<double> wheel;
    if (changed->channel(signals::names::wheelFiltered))
      wheel = sectionSpectrum(*changed, section, settings.window, signals::names::wheelFiltered).density;
    changed->frequency = std::move(box.frequency);
    changed->psd = std::move(box.density);
    changed->psdWheel = std::move(wheel);
    changed->psdWindow = settings.window;
  } catch (const signals::SignalError& error) {  // the filtered signals are right all the same
    problem = std::string("Spectrum not updated: ") + error.what();
  }
  return changed;
}

std::shared_ptr<const results::RunResult> withScalogram(const results::RunResult& result) {
  auto changed = std::make_shared<results::RunResult>(result);
  constexpr std::size_t fewest = 64;  // samples, as for a run
  if (!changed->channel(signals::names::axleBoxFiltered) || changed->position.size() != changed->time.size() ||
      changed->time.size() < fewest)
    return changed;
  try {
    signals::WaveletOptions options;
    options.cell = 0;
    std::vector<std::string> notes;
    signals::Scalogram scalogram =
        scalogramMap(signals::seriesOf(*changed, signals::names::axleBoxFiltered), options, notes);
    changed->scalogramFrequency = std::move(scalogram.frequency);
    changed->scalogramTime = std::move(scalogram.time);
    changed->scalogramPower = std::move(scalogram.power);
    changed->coneOfInfluence = std::move(scalogram.coneOfInfluence);
    changed->scalogramPosition.clear();
    for (const double time : changed->scalogramTime)
      changed->scalogramPosition.push_back(signals::interpolateLinear(changed->time, changed->position, time));
  } catch (const signals::SignalError&) {
    // What was there stays.
  }
  return changed;
}

}  // namespace squat::analysis
