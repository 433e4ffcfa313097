#include "simulation/SignalRecorder.h"

#include <algorithm>

#include "core/Errors.h"
#include "signals/SignalError.h"

namespace squat::simulation {

namespace {

const std::string kComplete = "/recorder/complete";

}  // namespace

SignalRecorder::SignalRecorder(const dynamics::Rolling& rolling, std::size_t stepsPerSample)
    : signals_(outputSignals(rolling)),
      sample_(signals_.size()),
      filter_(rolling.stepSize(), stepsPerSample, signals_.size()) {}

void SignalRecorder::onEveryStep(const dynamics::Rolling& rolling) {
  for (std::size_t i = 0; i < signals_.size(); ++i) sample_[i] = signals_[i].probe(rolling);
  filter_.push(sample_.data());
}

double SignalRecorder::latest(const std::string& name) const {
  for (std::size_t i = 0; i < signals_.size(); ++i)
    if (signals_[i].name == name) return filter_.latest(i);
  return 0;
}

const std::vector<double>& SignalRecorder::recorded(const std::string& name) const {
  std::size_t channel = 0;
  while (channel < signals_.size() && signals_[channel].name != name) ++channel;
  return filter_.state().complete.at(channel);
}

void SignalRecorder::store(results::RunResult& result, std::size_t samples, double cutoff) const {
  auto series = filter_.finish();
  result.time.clear(), result.signals.clear();
  if (series.empty() || series[0].values.empty()) return;
  const std::size_t kept = std::min(samples, series[0].values.size());
  for (std::size_t i = 0; i < kept; ++i) result.time.push_back(series[0].timeAt(i));
  std::vector<results::Channel> filtered;
  for (std::size_t c = 0; c < signals_.size(); ++c) {
    const auto& signal = signals_[c];
    if (signal.filteredName) {
      // Filtered with what the record holds beyond its end, then cut.
      auto values = signals::filteredPartner(series[c], cutoff).values;
      values.resize(kept);
      filtered.push_back({signal.filteredName, signal.unit,
                          std::string(signal.name) + ", Butterworth of order 4 forward and back", std::move(values)});
    }
    series[c].values.resize(kept);
    if (c + 1 == signals_.size())
      result.position = std::move(series[c].values);
    else
      result.signals.push_back({signal.name, signal.unit, signal.description, std::move(series[c].values)});
  }
  result.signals.insert(result.signals.end(), filtered.begin(), filtered.end());
}

void SignalRecorder::save(results::ArrayTree& tree) const {
  const auto& state = filter_.state();
  tree.addScalar("/recorder/pushed", static_cast<double>(state.pushed), "1");
  tree.add("/recorder/last", state.last, "1");
  tree.add("/recorder/pending", state.pending, "1");
  for (std::size_t c = 0; c < state.complete.size(); ++c) {
    auto& array = tree.add(kComplete + std::to_string(c), state.complete[c], "1");
    setAttribute(array.attributes, "name", std::string(signals_[c].name));
  }
}

std::vector<double> recordedIn(const results::ArrayTree& tree, const std::string& name) {
  for (const auto& array : tree.arrays)
    if (array.path.starts_with(kComplete) && results::textAttribute(array.attributes, "name") == name)
      if (const auto* values = std::get_if<std::vector<double>>(&array.values)) return *values;
  return {};
}

void SignalRecorder::load(const results::ArrayTree& tree, const std::string& file) {
  signals::DecimatingFilterState state;
  const auto& pushed = results::valuesOf<double>(tree, "/recorder/pushed", file);
  if (pushed.size() != 1 || !(pushed[0] >= 0 && pushed[0] < 1e15))
    throw FileError(file, "/recorder/pushed", "is no number of samples");
  state.pushed = static_cast<std::uint64_t>(pushed[0]);
  state.last = results::valuesOf<double>(tree, "/recorder/last", file);
  state.pending = results::valuesOf<double>(tree, "/recorder/pending", file);
  for (std::size_t c = 0; c < signals_.size(); ++c)
    state.complete.push_back(results::valuesOf<double>(tree, kComplete + std::to_string(c), file));
  try {
    filter_.restore(std::move(state));
  } catch (const signals::SignalError& error) {
    throw FileError(file, "/recorder", error.what());
  }
}

}  // namespace squat::simulation
