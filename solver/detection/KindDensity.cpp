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

KindDensity::KindDensity(const SizeModel& model, const std::vector<Example>& examples, const PossibleDefects& possible)
    : model_(model),
      examples_(examples),
      joints_(model, pointersTo(possible.joints)),
      welds_(model, pointersTo(possible.welds)) {}

double KindDensity::of(Kind kind, const EventFeatures& event, const Vehicle& vehicle) {
  const double examples = ofExamples(kind, event, vehicle);
  if (kind != Kind::joint && kind != Kind::weld) return examples;
  const double paths = ofPaths(kind == Kind::joint ? joints_ : welds_, event, vehicle);
  return logSum({examples, paths}) - std::log(2.0);
}

double KindDensity::ofExamples(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const {
  const BandMatrix scatter = model_.betweenPassages() + vehicle.covariance;
  std::vector<double> logs;
  double weights = 0;
  for (const auto& example : examples_) {
    if (example.kind != kind) continue;
    const auto* deviation = model_.deviation(example.vehicle);
    const BandValues expected = measuredEnergies(example) - (deviation ? *deviation : vehicle.mean);
    const double apart = std::log(event.speed / example.speed) / speedSpread;
    logs.push_back(std::log(std::max(example.weight, minimumWeight)) - 0.5 * apart * apart +
                   logDensityOf(matchOf(event, expected, vehicle, scatter)));
    weights += example.weight * std::exp(-0.5 * apart * apart);
  }
  return logSum(logs) - std::log(std::max(weights, minimumWeight));
}

double KindDensity::ofPaths(ExpectedBySpeed& paths, const EventFeatures& event, const Vehicle& vehicle) const {
  const BandMatrix scatter = model_.betweenPassages() + vehicle.covariance;
  std::vector<double> logs;
  for (const auto& expected : paths.at(event.speed))
    logs.push_back(logDensityOf(matchOf(event, expected, vehicle, scatter)));
  return logSum(logs) - std::log(static_cast<double>(logs.size()));
}

}  // namespace squat::detection
