#include "detection/KindDensity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "detection/LogSum.h"

namespace squat::detection {
namespace {

constexpr double minimumWeight = 1e-9;

std::vector<const PathSpectrum*> pointersTo(const std::vector<PathSpectrum>& paths) {
  std::vector<const PathSpectrum*> pointers;
  for (const auto& path : paths) pointers.push_back(&path);
  return pointers;
}

}  // namespace

KindDensity::KindDensity(const SizeModel& model, const std::vector<Example>& examples, const PossibleDefects& possible,
                         const std::vector<EventFeatures>& events, ThreadTeam& team, Monitor& monitor)
    : betweenPassages_(model.betweenPassages()),
      joints_(model, pointersTo(possible.joints), events, team, monitor),
      welds_(model, pointersTo(possible.welds), events, team, monitor) {
  for (const auto& example : examples) {
    const auto* deviation = model.deviation(example.vehicle);
    Passage passage{measuredEnergies(example), deviation != nullptr, example.speed, example.weight};
    if (deviation) passage.energies -= *deviation;
    passages_[example.kind].push_back(passage);
  }
}

double KindDensity::of(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const {
  const double examples = ofExamples(kind, event, vehicle);
  if (kind != Kind::joint && kind != Kind::weld) return examples;
  const double paths = ofPaths(kind == Kind::joint ? joints_ : welds_, event, vehicle);
  return logSum({examples, paths}) - std::log(2.0);
}

double KindDensity::ofExamples(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const {
  const auto found = passages_.find(kind);
  if (found == passages_.end()) return -std::numeric_limits<double>::infinity();
  const BandMatrix scatter = betweenPassages_ + vehicle.covariance;
  std::vector<double> logs;
  double weights = 0;
  for (const auto& passage : found->second) {
    const BandValues expected = passage.isFreed ? passage.energies : BandValues(passage.energies - vehicle.mean);
    const double apart = std::log(event.speed / passage.speed) / speedSpread;
    logs.push_back(std::log(std::max(passage.weight, minimumWeight)) - 0.5 * apart * apart +
                   logDensityOf(matchOf(event, expected, vehicle, scatter)));
    weights += passage.weight * std::exp(-0.5 * apart * apart);
  }
  return logSum(logs) - std::log(std::max(weights, minimumWeight));
}

double KindDensity::ofPaths(const ExpectedBySpeed& paths, const EventFeatures& event, const Vehicle& vehicle) const {
  const BandMatrix scatter = betweenPassages_ + vehicle.covariance;
  std::vector<double> logs;
  for (const auto& expected : paths.at(event.speed))
    logs.push_back(logDensityOf(matchOf(event, expected, vehicle, scatter)));
  return logSum(logs) - std::log(static_cast<double>(logs.size()));
}

}  // namespace squat::detection
