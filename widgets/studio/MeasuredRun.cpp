#include "studio/MeasuredRun.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "signals/Butterworth.h"
#include "signals/SignalError.h"

namespace squat::studio {
namespace {

constexpr double alignmentCutoff = 2000;  // [Hz] peaks are compared below it
constexpr double kept = 5;                // [m] on both sides of the impact: records may be kilometres long

// Index of the largest absolute value; 0 for an empty list.
std::size_t largest(const std::vector<double>& values) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i]) > std::abs(values[at])) at = i;
  return at;
}

double impactOf(const results::RunResult& reference) {
  const auto* values = reference.signal("aba_filtered");
  if (!values || values->empty() || values->size() != reference.position.size()) return 0;
  return reference.position[largest(*values)];
}

std::shared_ptr<const results::RunResult> runOf(const measured::MeasuredSignal& signal, const std::string& path,
                                                double speed, const results::RunResult* reference) {
  if (!signal.series.unit.empty() && signal.series.unit != "m/s2")
    throw FileError(path, signal.series.name, "is in " + signal.series.unit + ", not an acceleration",
                    "overlay a signal in m/s2 or g");
  auto result = std::make_shared<results::RunResult>();
  result->stem = signal.series.name;
  result->title = signal.run.empty() ? signal.series.name : signal.run;
  result->warnings = signal.notes;
  result->complete = true;
  const std::size_t count = signal.series.values.size();
  for (std::size_t i = 0; i < count; ++i) result->time.push_back(signal.series.timeAt(i));
  result->position = signal.position;
  if (result->position.size() != count) {
    result->position.clear();
    for (double time : result->time) result->position.push_back(speed * (time - result->time.front()));
  }
  result->speed = result->time.back() > result->time.front() ? (result->position.back() - result->position.front()) /
                                                                   (result->time.back() - result->time.front())
                                                             : speed;
  std::vector<double> filtered = signal.series.values;
  try {
    if (signal.series.rate() > 2.5 * alignmentCutoff)
      filtered = signals::lowPass(signal.series, alignmentCutoff).values;
  } catch (const signals::SignalError&) {
    // Too short to be filtered: shown as it is.
  }
  const double shift = (reference ? impactOf(*reference) : 0.0) - result->position[largest(filtered)];
  for (double& position : result->position) position += shift;
  // Positions rise: what lies near the impact is one stretch.
  const double middle = reference ? impactOf(*reference) : 0.0;
  const auto& places = result->position;
  const auto first = std::lower_bound(places.begin(), places.end(), middle - kept) - places.begin();
  const auto last = std::upper_bound(places.begin(), places.end(), middle + kept) - places.begin();
  std::vector<double> raw = signal.series.values;
  for (std::vector<double>* values : {&result->time, &result->position, &raw, &filtered}) {
    values->erase(values->begin() + last, values->end());
    values->erase(values->begin(), values->begin() + first);
  }
  result->signals.push_back({"aba", "m/s2", "measured", std::move(raw)});
  result->signals.push_back({"aba_filtered", "m/s2", "measured, low-passed", filtered});
  return result;
}

}  // namespace

std::vector<std::shared_ptr<const results::RunResult>> measuredRuns(const QString& path, double speed,
                                                                    const results::RunResult* reference,
                                                                    const measured::SignalFileOptions& options) {
  const auto read = measured::readSignals(path.toStdString(), options);
  if (read.empty()) throw FileError(path.toStdString(), "", "contains no signal");
  std::vector<std::shared_ptr<const results::RunResult>> runs;
  for (auto signal : read) {
    if (signal.position.empty() && options.speed == 0)
      signal.notes.push_back("no speed in file; using the case's speed (" + QString::number(speed).toStdString() +
                             " m/s)");
    runs.push_back(runOf(signal, path.toStdString(), speed, reference));
  }
  return runs;
}

}  // namespace squat::studio
