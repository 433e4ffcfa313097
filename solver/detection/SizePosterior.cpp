#include "detection/SizePosterior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace squat::detection {
namespace {

constexpr Eigen::Index bands = static_cast<Eigen::Index>(bandCount);
constexpr double sharedEvidence = 0.5;  // events of a record are not independent looks at its vehicle
constexpr int maximumPasses = 30;
constexpr double atRest = 1e-3;                 // of log10 energy
constexpr double speedStep = 0.02;              // of the logarithm: squats are computed for speeds this far apart
constexpr std::size_t maximumForVehicle = 200;  // of events that the vehicle is estimated from, the surest
constexpr double surelyNone = 1e-3;             // probability below which an event does not count for the vehicle

// y without u of every possible squat.
using Expected = std::vector<BandValues>;

class ExpectedBySpeed {
 public:
  ExpectedBySpeed(const SizeModel& model, const PossibleSquats& possible) : model_(model), possible_(possible) {}

  const Expected& at(double speed) {
    const long step = std::lround(std::log(speed) / speedStep);
    const auto [found, isNew] = expected_.try_emplace(step);
    if (isNew) {
      const double rounded = std::exp(speedStep * static_cast<double>(step));
      for (const auto& squat : possible_.all())
        found->second.push_back(model_.expected(pathEnergies(squat.path, rounded), rounded));
    }
    return found->second;
  }

 private:
  const SizeModel& model_;
  const PossibleSquats& possible_;
  std::map<long, Expected> expected_;
};

// Probability of each possible squat; adds to the normal equations of the vehicle what the event says, weighted.
struct Normal {
  BandMatrix matrix = BandMatrix::Zero();
  BandValues right = BandValues::Zero();
};

struct Fit {
  std::vector<double> probability;
  double logDensity = 0;  // of the event, if it is a squat
};

Fit fitOf(const EventFeatures& event, const Expected& expected, const PossibleSquats& possible, const Vehicle& vehicle,
          const BandMatrix& scatter, double weight, Normal* normal) {
  std::vector<EventMatch> matches;
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& each : expected) {
    matches.push_back(matchOf(event, each, vehicle, scatter));
    largest = std::max(largest, matches.back().logDensity);
  }
  Fit fit;
  auto& result = fit.probability;
  double sum = 0;
  for (std::size_t g = 0; g < matches.size(); ++g) {
    result.push_back(possible.all()[g].weight * std::exp(matches[g].logDensity - largest));
    sum += result.back();
  }
  fit.logDensity = largest + std::log(sum);
  for (std::size_t g = 0; g < matches.size(); ++g) {
    result[g] /= sum;
    if (!normal || result[g] < 1e-6) continue;
    const BandMatrix shares = matches[g].share.asDiagonal();
    normal->matrix += weight * result[g] * shares * matches[g].covariance.solve(shares);
    normal->right += weight * result[g] * (shares * matches[g].covariance.solve(matches[g].distance));
  }
  return fit;
}

double quantile(std::vector<std::pair<double, double>> values, double share) {
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (const auto& [value, weight] : values)
    if ((sum += weight) >= share) return value;
  return values.back().first;
}

SquatSize sizeFrom(const std::vector<double>& probability, const PossibleSquats& possible) {
  SquatSize size;
  std::vector<std::pair<double, double>> lengths, depths;
  for (std::size_t g = 0; g < probability.size(); ++g) {
    const auto& squat = possible.all()[g];
    size.severity[static_cast<std::size_t>(squat.severity)] += probability[g];
    lengths.emplace_back(squat.length, probability[g]), depths.emplace_back(squat.depth, probability[g]);
  }
  size.length = quantile(lengths, 0.5), size.lengthLow = quantile(lengths, 0.05);
  size.lengthHigh = quantile(lengths, 0.95);
  size.depth = quantile(depths, 0.5), size.depthLow = quantile(depths, 0.05), size.depthHigh = quantile(depths, 0.95);
  return size;
}

// The vehicle as passages of known sizes show it.
Vehicle knownFrom(const SizeModel& model, const std::vector<Example>& own) {
  Vehicle vehicle{BandValues::Zero(), model.betweenVehicles()};
  const BandMatrix precision = model.betweenPassages().inverse();
  BandMatrix normal = model.betweenVehicles().inverse();
  BandValues right = BandValues::Zero();
  for (const auto& example : own) {
    if (!hasSize(example)) continue;
    normal += precision;
    right += precision * (measuredEnergies(example) - model.expected(pathEnergies(example), example.speed));
  }
  vehicle.covariance = normal.inverse();
  vehicle.mean = vehicle.covariance * right;
  return vehicle;
}

// The events whose squats the vehicle is estimated from.
std::vector<std::size_t> surest(const std::vector<double>& squat) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < squat.size(); ++i)
    if (squat[i] > surelyNone) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return squat[a] > squat[b]; });
  order.resize(std::min(order.size(), maximumForVehicle));
  return order;
}

}  // namespace

PossibleSquats::PossibleSquats(std::size_t count, const SeverityLimits& limits) {
  constexpr std::uint32_t seed = 999;
  std::array<double, 3> members{};
  for (const auto& example : exampleSquats(count, seed)) {
    const auto severity = severityOf(example.length, example.depth, limits);
    squats_.push_back({example.length, example.depth, severity, 0, PathSpectrum(example.defect)});
    members[static_cast<std::size_t>(severity)] += 1;
  }
  const auto classes =
      static_cast<double>(std::count_if(members.begin(), members.end(), [](double n) { return n > 0; }));
  for (auto& squat : squats_) squat.weight = 1 / (classes * members[static_cast<std::size_t>(squat.severity)]);
}

SquatSizes squatSizes(const SizeModel& model, const PossibleSquats& possible, const std::vector<EventFeatures>& events,
                      const std::vector<double>& squat, const std::vector<Example>& own) {
  ExpectedBySpeed expected(model, possible);
  const Vehicle known = knownFrom(model, own);
  const BandMatrix precision = known.covariance.inverse();
  const auto forVehicle = surest(squat);
  Vehicle vehicle = known;
  for (int pass = 0; pass < maximumPasses; ++pass) {
    Normal normal;
    const BandMatrix scatter = model.betweenPassages() + vehicle.covariance;
    for (const auto i : forVehicle)
      fitOf(events[i], expected.at(events[i].speed), possible, vehicle, scatter, sharedEvidence * squat[i], &normal);
    const BandMatrix all = precision + normal.matrix;
    const BandValues step = all.ldlt().solve(precision * (known.mean - vehicle.mean) + normal.right);
    vehicle.mean += step;
    vehicle.covariance = all.inverse();
    if (step.cwiseAbs().maxCoeff() < atRest) break;
  }
  const BandMatrix scatter = model.betweenPassages() + vehicle.covariance;
  SquatSizes sizes;
  sizes.vehicle = vehicle;
  for (const auto& event : events) {
    const auto fit = fitOf(event, expected.at(event.speed), possible, vehicle, scatter, 0, nullptr);
    sizes.each.push_back(sizeFrom(fit.probability, possible));
    sizes.each.back().logDensity = fit.logDensity;
  }
  return sizes;
}

}  // namespace squat::detection
