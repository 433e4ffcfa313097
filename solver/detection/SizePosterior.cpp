#include "detection/SizePosterior.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "detection/CancellableLoop.h"

namespace squat::detection {
namespace {

constexpr int maximumPasses = 30;
constexpr double atRest = 1e-3;                 // of log10 energy
constexpr std::size_t maximumForVehicle = 200;  // of events that the vehicle is estimated from, the surest
constexpr double surelyNone = 1e-3;             // probability below which an event does not count for the vehicle

// Equations of the vehicle, Gauss-Newton.
struct Normal {
  BandMatrix matrix = BandMatrix::Zero();
  BandValues right = BandValues::Zero();
};

struct Fit {
  std::vector<double> probability;  // of each possible squat
  double logDensity = 0;            // of the event, if it is a squat
};

Fit fitOf(const EventFeatures& event, const std::vector<BandValues>& expected, const PossibleSquats& possible,
          const Vehicle& vehicle, const BandMatrix& scatter, std::optional<Severity> severity) {
  Fit fit;
  const auto isOfSeverity = [severity](const PossibleSquats::Squat& squat) { return squat.severity == *severity; };
  // With other limits of the severities there may be none of one: then it says nothing of the size.
  if (severity && std::none_of(possible.all().begin(), possible.all().end(), isOfSeverity)) severity.reset();
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < expected.size(); ++g) {
    const bool isPossible = !severity || isOfSeverity(possible.all()[g]);
    fit.probability.push_back(isPossible ? logDensityOf(matchOf(event, expected[g], vehicle, scatter))
                                         : -std::numeric_limits<double>::infinity());
    largest = std::max(largest, fit.probability.back());
  }
  double sum = 0;
  for (std::size_t g = 0; g < expected.size(); ++g) {
    fit.probability[g] = possible.all()[g].weight * std::exp(fit.probability[g] - largest);
    sum += fit.probability[g];
  }
  for (double& probability : fit.probability) probability /= sum;
  fit.logDensity = largest + std::log(sum);
  return fit;
}

// What one event says of the vehicle, `weight` times.
void addTo(Normal& normal, const EventFeatures& event, const std::vector<BandValues>& expected, const Fit& fit,
           const Vehicle& vehicle, const BandMatrix& scatter, double weight) {
  constexpr double negligible = 1e-6;
  for (std::size_t g = 0; g < expected.size(); ++g) {
    if (fit.probability[g] < negligible) continue;
    const auto match = matchOf(event, expected[g], vehicle, scatter);
    const Eigen::LLT<BandMatrix> covariance(match.covariance);
    const BandMatrix shares = match.share.asDiagonal();
    normal.matrix += weight * fit.probability[g] * shares * covariance.solve(shares);
    normal.right += weight * fit.probability[g] * (shares * covariance.solve(match.distance));
  }
}

// The values below which 5 %, half and 95 % of the weight lie.
std::array<double, 3> quantiles(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  std::array<double, 3> found{};
  found.fill(values.back().first);
  double sum = 0;
  std::size_t next = 0;
  for (const auto& [value, weight] : values) {
    sum += weight;
    for (constexpr std::array shares{0.05, 0.5, 0.95}; next < shares.size() && sum >= shares[next]; ++next)
      found[next] = value;
  }
  return found;
}

SquatSize sizeFrom(const Fit& fit, const PossibleSquats& possible) {
  SquatSize size;
  std::vector<std::pair<double, double>> lengths, depths;
  for (std::size_t g = 0; g < fit.probability.size(); ++g) {
    const auto& squat = possible.all()[g];
    size.severity[static_cast<std::size_t>(squat.severity)] += fit.probability[g];
    lengths.emplace_back(squat.length, fit.probability[g]), depths.emplace_back(squat.depth, fit.probability[g]);
  }
  const auto length = quantiles(std::move(lengths)), depth = quantiles(std::move(depths));
  size.lengthLow = length[0], size.length = length[1], size.lengthHigh = length[2];
  size.depthLow = depth[0], size.depth = depth[1], size.depthHigh = depth[2];
  size.logDensity = fit.logDensity;
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
std::vector<std::size_t> surest(const std::vector<Belief>& beliefs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < beliefs.size(); ++i)
    if (beliefs[i].squat > surelyNone) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return beliefs[a].squat > beliefs[b].squat; });
  order.resize(std::min(order.size(), maximumForVehicle));
  return order;
}

}  // namespace

SizePosterior::SizePosterior(const SizeModel& model, const PossibleSquats& possible,
                             const std::vector<EventFeatures>& events, ThreadTeam& team, Monitor& monitor)
    : model_(model), possible_(possible), expected_(model, possible.paths(), events, team, monitor) {}

std::optional<Vehicle> SizePosterior::vehicleOf(const std::vector<EventFeatures>& events,
                                                const std::vector<Belief>& beliefs, const std::vector<Example>& own,
                                                const std::optional<BandValues>& start, ThreadTeam& team,
                                                Monitor& monitor) const {
  const Vehicle known = knownFrom(model_, own);
  const BandMatrix precision = known.covariance.inverse();
  const auto forVehicle = surest(beliefs);
  Vehicle vehicle = known;
  if (start) vehicle.mean = *start;
  for (int pass = 0; pass < maximumPasses; ++pass) {
    const BandMatrix scatter = model_.betweenPassages() + vehicle.covariance;
    std::vector<Normal> parts(forVehicle.size());
    const bool isDone = forEachUnlessCancelled(team, monitor, forVehicle.size(), [&](std::size_t i) {
      const auto& event = events[forVehicle[i]];
      const auto& belief = beliefs[forVehicle[i]];
      const auto& squats = expected_.at(event.speed);
      const auto fit = fitOf(event, squats, possible_, vehicle, scatter, belief.severity);
      addTo(parts[i], event, squats, fit, vehicle, scatter, sharedEvidence * belief.squat);
    });
    if (!isDone) return std::nullopt;
    Normal normal;
    for (const auto& part : parts) normal.matrix += part.matrix, normal.right += part.right;
    const BandMatrix all = precision + normal.matrix;
    const BandValues step = all.ldlt().solve(precision * (known.mean - vehicle.mean) + normal.right);
    vehicle.mean += step;
    vehicle.covariance = all.inverse();
    if (step.cwiseAbs().maxCoeff() < atRest) break;
  }
  return vehicle;
}

SquatSize SizePosterior::sizeOf(const EventFeatures& event, std::optional<Severity> severity,
                                const Vehicle& vehicle) const {
  const BandMatrix scatter = model_.betweenPassages() + vehicle.covariance;
  return sizeFrom(fitOf(event, expected_.at(event.speed), possible_, vehicle, scatter, severity), possible_);
}

SquatSizes squatSizes(const SizeModel& model, const PossibleSquats& possible, const std::vector<EventFeatures>& events,
                      const std::vector<Belief>& beliefs, const std::vector<Example>& own) {
  ThreadTeam team(1);
  Monitor unwatched;
  const SizePosterior posterior(model, possible, events, team, unwatched);
  SquatSizes sizes;
  sizes.vehicle = *posterior.vehicleOf(events, beliefs, own, {}, team, unwatched);
  for (std::size_t i = 0; i < events.size(); ++i)
    sizes.each.push_back(posterior.sizeOf(events[i], beliefs[i].severity, sizes.vehicle));
  return sizes;
}

}  // namespace squat::detection
