#include "detection/KindDensity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "detection/LogSum.h"

namespace squat::detection {
namespace {

std::vector<const PathSpectrum*> pointersTo(const std::vector<PathSpectrum>& paths) {
  std::vector<const PathSpectrum*> pointers;
  for (const auto& path : paths) pointers.push_back(&path);
  return pointers;
}

}  // namespace

KindDensity::KindDensity(const SizeModel& model, const std::vector<Example>& examples, const PossibleDefects& possible,
                         const std::vector<EventFeatures>& events, ThreadTeam& team, Monitor& monitor)
    : betweenPassages_(model.betweenPassages()) {
  for (const auto& [kind, paths] : possible.others) {
    if (monitor.cancelled()) return;
    paths_.try_emplace(kind, model, pointersTo(paths), events, team, monitor);
  }
  for (const auto& example : examples) {
    const auto* deviation = model.deviation(example.vehicle);
    Passage passage{measuredEnergies(example), deviation != nullptr, example.speed, example.weight};
    if (deviation) passage.energies -= *deviation;
    passages_[example.kind].push_back(passage);
    reaches_[example.kind].push_back(example.reach);
  }
}

double KindDensity::of(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const {
  const double examples = ofExamples(kind, event, vehicle);
  const auto paths = paths_.find(kind);
  if (paths == paths_.end()) return examples;
  // Few examples are no density.
  constexpr double enough = 40;
  const auto found = passages_.find(kind);
  const double count = found == passages_.end() ? 0 : static_cast<double>(found->second.size());
  const double ofThese = count / (count + enough);
  std::vector<double> parts{ofPaths(paths->second, event, vehicle)};
  double weights = 1;
  if (std::isfinite(examples)) parts.push_back(std::log(ofThese) + examples), weights += ofThese;
  if (kind == Kind::other) parts.push_back(ofNoneKnown(event, vehicle)), weights += 1;
  return logSum(parts) - std::log(weights);
}

double KindDensity::logReach(Kind kind, const EventFeatures& event) const {
  // Of a kind with few examples as of one that is loud over any length up to two metres, twice.
  constexpr double longest = 2, unseen = 2;
  const double asFar = std::clamp(1 - event.reach / longest, 0.05, 1.0);
  const auto found = reaches_.find(kind);
  if (found == reaches_.end()) return std::log(asFar);
  const auto count = std::count_if(found->second.begin(), found->second.end(),
                                   [&](double reach) { return reach >= event.reach - 1e-9; });
  return std::log((static_cast<double>(count) + unseen * asFar) / (static_cast<double>(found->second.size()) + unseen));
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
    logs.push_back(std::log(std::max(passage.weight, leastWeight)) - 0.5 * apart * apart +
                   logDensityOf(matchOf(event, expected, vehicle, scatter)));
    weights += passage.weight * std::exp(-0.5 * apart * apart);
  }
  return logSum(logs) - std::log(std::max(weights, leastWeight));
}

double KindDensity::ofPaths(const ExpectedBySpeed& paths, const EventFeatures& event, const Vehicle& vehicle) const {
  const BandMatrix scatter = betweenPassages_ + vehicle.covariance;
  std::vector<double> logs;
  for (const auto& expected : paths.at(event.speed))
    logs.push_back(logDensityOf(matchOf(event, expected, vehicle, scatter)));
  return logSum(logs) - std::log(static_cast<double>(logs.size()));
}

double KindDensity::ofNoneKnown(const EventFeatures& event, const Vehicle& vehicle) const {
  constexpr double wider = 1.5, byItself = 0.5;  // of all together; of each band, in decades of energy
  BandValues mean = BandValues::Zero();
  BandMatrix squares = BandMatrix::Zero();
  double count = 0;
  for (const auto& [kind, paths] : paths_) {
    const auto& moments = paths.momentsAt(event.speed);
    mean += moments.sum, squares += moments.squares, count += moments.count;
  }
  mean /= count;
  const BandMatrix spread = squares / count - mean * mean.transpose();
  BandMatrix scatter = wider * wider * spread + betweenPassages_ + vehicle.covariance;
  scatter.diagonal().array() += byItself * byItself;
  return logDensityOf(matchOf(event, mean, vehicle, scatter));
}

}  // namespace squat::detection
