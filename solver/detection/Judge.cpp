#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "detection/CancellableLoop.h"
#include "detection/Examples.h"
#include "detection/KindDensity.h"
#include "detection/LogSum.h"

namespace squat::detection {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double minimumVehicleWeight = 0.02;
constexpr std::size_t kindCount = 6;
// Prior odds of a squat to each other kind, to the power of `trust` as all the rest: squats are what is looked for.
// With 10, as for examples of joints and welds alone, more irregularities of shapes that no example has are called
// squats, and surer.
constexpr double squatOdds = 3;
constexpr double rarerOthers = 6;  // than joints or welds: crossings, and what nobody has seen
// Power of all likelihoods: examples and paths are not all that there is, and what they leave out is not independent
// from band to band. Chosen so that sureness is a frequency on four vehicles and 106 irregularities that no example
// has.
constexpr double trust = 0.85;
// What it costs to miss a light, a moderate and a severe squat, by a look at something else: the probability of another
// kind must be so many times a squat's before the event is called that. Its sureness stays its probability. With six
// for a severe one, others of vehicles left out were called squats at 17 to 45 %, and no more squats were found.
constexpr std::array missedCost{0.6, 0.8, 3.0};

// Logarithm of a normal density of log10 energies, band by band added: each band has a variance of its own, and all
// share a deviation of variance c, so that the covariance is D + c 1 1^T. Its inverse and determinant are closed forms
// (Sherman and Morrison): d^T (D + c 1 1^T)^-1 d = sum d^2/v - (sum d/v)^2 / (1/c + sum 1/v), |D + c 1 1^T| = prod v (1
// + c sum 1/v).
class LogDensity {
 public:
  // Where `signal` and noise are expected and their sum `seen`.
  void add(double seen, double signal, double noise, double freedom, double spread) {
    const double expected = signal + noise;
    if (!(expected > 0) || !(seen > 0)) {
      if (seen > 0) impossible_ = true;
      return;
    }
    const double scatter = std::sqrt(2 * noise * noise + 4 * signal * noise) / std::sqrt(freedom);
    const double ofNoise = scatter / expected / std::log(10.0), ofSignal = spread * signal / expected;
    const double variance = ofNoise * ofNoise + ofSignal * ofSignal + 1e-4;
    const double distance = std::log10(seen / expected), share = signal / expected;  // noise has no common deviation
    squares_ += distance * distance / variance;
    linear_ += share * distance / variance;
    weights_ += share * share / variance;
    logs_ += std::log(variance);
  }
  double value(double commonSpread) const {
    if (impossible_) return -1e3;
    const double c = commonSpread * commonSpread;
    return -0.5 * (squares_ - c * linear_ * linear_ / (1 + c * weights_) + logs_ + std::log1p(c * weights_));
  }

 private:
  double squares_ = 0, linear_ = 0, weights_ = 0, logs_ = 0;
  bool impossible_ = false;
};

// Squats of each severity are a group, and so is each other kind: all of a kind's groups count the same.
constexpr std::size_t groups = 3 + kindCount;
std::size_t groupOf(const Example& example, const SeverityLimits& limits) {
  return example.kind == Kind::squat ? static_cast<std::size_t>(severityOf(example.length, example.depth, limits))
                                     : 3 + static_cast<std::size_t>(example.kind);
}

struct Weighted {
  double value, weight;
};

// Each example stands for sizes around its own: a ninth of its weight at each of nine quantiles of a normal
// distribution of the logarithm.
constexpr std::array normalQuantiles{-1.593, -0.967, -0.589, -0.282, 0.0, 0.282, 0.589, 0.967, 1.593};

void addSizes(std::vector<Weighted>& sizes, double size, double weight, double spread) {
  for (const double q : normalQuantiles)
    sizes.push_back({size * std::exp(spread * q), weight / static_cast<double>(normalQuantiles.size())});
}

void addSeverities(std::array<double, 3>& severities, double length, double depth, double weight,
                   const JudgementOptions& options) {
  constexpr double count = static_cast<double>(normalQuantiles.size() * normalQuantiles.size());
  for (const double l : normalQuantiles)
    for (const double d : normalQuantiles)
      severities[static_cast<std::size_t>(severityOf(length * std::exp(options.sizeSpread * l),
                                                     depth * std::exp(options.sizeSpread * d), options.limits))] +=
          weight / count;
}

// The value below which `share` of the weight lies.
double quantile(std::vector<Weighted> values, double share) {
  std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  const double total = std::accumulate(values.begin(), values.end(), 0.0,
                                       [](double sum, const Weighted& each) { return sum + each.weight; });
  double sum = 0;
  for (const auto& each : values)
    if ((sum += each.weight) >= share * total) return each.value;
  return values.empty() ? 0 : values.back().value;
}

void takeSize(const SquatSize& size, Judgement& judgement) {
  const auto likeliest = std::max_element(size.severity.begin(), size.severity.end());
  judgement.severity = static_cast<Severity>(likeliest - size.severity.begin());
  judgement.severitySureness = *likeliest;
  judgement.severities = size.severity;
  judgement.length = size.length, judgement.lengthLow = size.lengthLow, judgement.lengthHigh = size.lengthHigh;
  judgement.depth = size.depth, judgement.depthLow = size.depthLow, judgement.depthHigh = size.depthHigh;
}

// Of a record whose events ask for a vehicle that differs so much from the examples': of vehicles as theirs, the share
// that differs more is p = exp(-x) (1 + x + x^2/2), 2 x the squared distance, chi-square with six degrees of freedom.
// Against records of something else, which are one in a few hundred: p / (p + 0.002).
double axleBoxProbability(const BandValues& apart, const BandMatrix& betweenVehicles) {
  static_assert(bandCount == 6);
  constexpr double somethingElse = 0.002;
  const double x = 0.5 * apart.dot(betweenVehicles.llt().solve(apart));
  const double share = std::exp(-x) * (1 + x + 0.5 * x * x);
  return share / (share + somethingElse);
}

// Where the band from 900 Hz is not shown, no squat, joint or weld is surer: in 0.37 km of measured ordinary track,
// sampled at 2 kHz, seven impacts were squats with more than 90 % otherwise.
constexpr double surenessWithoutShortWaves = 0.75;
constexpr std::size_t bandOfShortWaves = 4;

// What is not from an axle box, or not shown whole, is nothing known.
void takeDoubt(const EventFeatures& event, double axleBox, Judgement& judgement) {
  judgement.axleBox = axleBox;
  const double known = axleBox * (event.freedom[bandOfShortWaves] > 0 ? 1.0 : surenessWithoutShortWaves);
  judgement.squatProbability *= known;
  const double other = 1 - known * (1 - judgement.otherProbability);
  judgement.sureness *= known;
  if (judgement.kind != Kind::other && judgement.sureness >= other) return;
  judgement.kind = Kind::other, judgement.sureness = other;
}

// In their own order.
std::vector<std::size_t> likeliestSquats(std::size_t count, const std::function<double(std::size_t)>& probability) {
  constexpr std::size_t maximum = 400;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < count; ++i) order.emplace_back(-probability(i), i);
  std::sort(order.begin(), order.end());
  order.resize(std::min(count, maximum));
  std::vector<std::size_t> likeliest;
  for (const auto& [negative, i] : order) likeliest.push_back(i);
  std::sort(likeliest.begin(), likeliest.end());
  return likeliest;
}

// Reports how many of `count` events are judged.
std::function<void(std::size_t)> reportingTo(Monitor& monitor, std::size_t count) {
  return [&monitor, count, start = Clock::now()](std::size_t done) {
    Progress progress;
    progress.phase = "judgement";
    progress.fraction = static_cast<double>(done) / static_cast<double>(count);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (progress.fraction > 0.02) progress.remainingSeconds = seconds * (1 / progress.fraction - 1);
    monitor.report(progress);
  };
}

}  // namespace

Judge::Judge(std::vector<Example> examples, JudgementOptions options, SizeModel sizes, std::vector<Example> own)
    : examples_(std::move(examples)), options_(options), sizes_(std::move(sizes)), own_(std::move(own)) {
  if (sizes_.isKnown()) possible_.emplace(options_.limits);
  std::vector<std::vector<std::size_t>> count(groups);  // of examples, a group and vehicle
  for (const auto& example : examples_) {
    const auto found = std::find(vehicles_.begin(), vehicles_.end(), example.vehicle);
    vehicleOf_.push_back(static_cast<std::size_t>(found - vehicles_.begin()));
    if (found == vehicles_.end()) vehicles_.push_back(example.vehicle);
  }
  for (auto& row : count) row.assign(vehicles_.size(), 0);
  for (std::size_t i = 0; i < examples_.size(); ++i) ++count[groupOf(examples_[i], options_.limits)][vehicleOf_[i]];
  for (std::size_t i = 0; i < examples_.size(); ++i) {
    const auto& row = count[groupOf(examples_[i], options_.limits)];
    const auto withGroup = std::count_if(row.begin(), row.end(), [](std::size_t n) { return n > 0; });
    const double share = examples_[i].kind == Kind::squat ? 1.0 / 3 : 1.0;  // of the kind
    prior_.push_back(std::log(share * std::max(examples_[i].weight, leastWeight)) -
                     std::log(static_cast<double>(withGroup)) - std::log(static_cast<double>(row[vehicleOf_[i]])));
  }
}

std::vector<double> Judge::logLikelihoods(const EventFeatures& event) const {
  std::vector<double> logs(examples_.size());
  for (std::size_t i = 0; i < examples_.size(); ++i) {
    const auto& example = examples_[i];
    const double ratio = event.speed / example.speed, apart = std::log(ratio) / speedSpread;
    logs[i] = prior_[i] - 0.5 * apart * apart;
    LogDensity density;
    for (std::size_t b = 0; b < bandCount; ++b)
      if (event.freedom[b] > 0)
        density.add(event.energy[b], example.energy[b] * ratio * ratio, event.noise[b], event.freedom[b],
                    options_.spread);
    logs[i] += density.value(options_.commonSpread);
  }
  return logs;
}

double Judge::logNothing(const EventFeatures& event) const {
  LogDensity density;
  for (std::size_t b = 0; b < bandCount; ++b)
    if (event.freedom[b] > 0) density.add(event.energy[b], 0, event.noise[b], event.freedom[b], 0);
  return std::log(options_.nothing) + density.value(0);
}

std::vector<double> Judge::forVehicles(const EventFeatures& event) const {
  const auto likelihoods = logLikelihoods(event);
  std::vector<std::vector<double>> ofVehicle(vehicles_.size());
  for (std::size_t i = 0; i < likelihoods.size(); ++i) ofVehicle[vehicleOf_[i]].push_back(likelihoods[i]);
  const double all = logSum(likelihoods) - std::log(static_cast<double>(vehicles_.size()));
  std::vector<double> logs;
  for (const auto& own : ofVehicle)  // a single event convinces nobody: at most a factor of e^3
    logs.push_back(sharedEvidence * std::clamp(logSum(own) - all, -3.0, 3.0));
  return logs;
}

std::optional<std::vector<double>> Judge::vehicleWeights(const std::vector<EventFeatures>& events, ThreadTeam& team,
                                                         Monitor& monitor) const {
  std::vector<std::vector<double>> parts(events.size());
  const bool isDone =
      forEachUnlessCancelled(team, monitor, events.size(), [&](std::size_t i) { parts[i] = forVehicles(events[i]); });
  if (!isDone) return std::nullopt;
  std::vector<double> logs(vehicles_.size(), 0.0);
  for (const auto& part : parts)
    for (std::size_t v = 0; v < logs.size(); ++v) logs[v] += part[v];
  const double sum = logSum(logs), n = static_cast<double>(vehicles_.size());
  for (auto& value : logs) value = std::exp(value - sum) * (1 - minimumVehicleWeight) + minimumVehicleWeight / n;
  return logs;
}

// The likelihoods are computed once more rather than kept: those of a long record are hundreds of megabytes.
Judgement Judge::weigh(const EventFeatures& event, const std::vector<double>& vehicles) const {
  std::vector<double> logs = logLikelihoods(event);
  for (std::size_t i = 0; i < logs.size(); ++i)
    logs[i] = examples_[i].kind == Kind::flat
                  ? -std::numeric_limits<double>::infinity()
                  : logs[i] + std::log(vehicles[vehicleOf_[i]] * static_cast<double>(vehicles_.size()));
  const double nothing = logNothing(event), some = logSum(logs);
  Judgement judgement;
  judgement.nothing = 1 / (1 + std::exp(some - nothing));
  std::array<double, kindCount> ofKind{};
  std::array<double, 3> ofSeverity{};
  std::vector<Weighted> lengths, depths;
  double offset = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const double weight = std::exp(logs[i] - some);
    const auto& example = examples_[i];
    ofKind[static_cast<std::size_t>(example.kind)] += weight;
    if (example.kind != Kind::squat) continue;
    offset += weight * example.offset;
    if (sizes_.isKnown()) continue;  // takeSizes() sets what follows
    addSeverities(ofSeverity, example.length, example.depth, weight, options_);
    addSizes(lengths, example.length, weight, options_.sizeSpread);
    addSizes(depths, example.depth, weight, options_.sizeSpread);
  }
  const auto best = std::max_element(ofKind.begin(), ofKind.end());
  judgement.kind = static_cast<Kind>(best - ofKind.begin());
  judgement.sureness = *best;
  judgement.squatProbability = ofKind[static_cast<std::size_t>(Kind::squat)];
  if (!(judgement.squatProbability > 0)) return judgement;
  judgement.offset = offset / judgement.squatProbability;
  if (sizes_.isKnown()) return judgement;
  const auto severity = std::max_element(ofSeverity.begin(), ofSeverity.end());
  judgement.severity = static_cast<Severity>(severity - ofSeverity.begin());
  judgement.severitySureness = *severity / judgement.squatProbability;
  for (std::size_t s = 0; s < ofSeverity.size(); ++s)
    judgement.severities[s] = ofSeverity[s] / judgement.squatProbability;
  judgement.length = quantile(lengths, 0.5), judgement.lengthLow = quantile(lengths, 0.05);
  judgement.lengthHigh = quantile(lengths, 0.95);
  judgement.depth = quantile(depths, 0.5), judgement.depthLow = quantile(depths, 0.05);
  judgement.depthHigh = quantile(depths, 0.95);
  return judgement;
}

void Judge::takeKind(const EventFeatures& event, const Vehicle& vehicle, const SquatSize& size,
                     const KindDensity& densities, Judgement& judgement) const {
  std::vector<double> logs;
  for (std::size_t k = 0; k < kindCount; ++k) logs.push_back(densities.of(static_cast<Kind>(k), event, vehicle));
  // As for joints and welds, half by examples, whose wheels may lose the rail, and half by paths, which do not show
  // that. By paths alone, two of 146 severe squats of 16 vehicles were called joints.
  auto& ofSquat = logs[static_cast<std::size_t>(Kind::squat)];
  ofSquat = logSum({ofSquat, size.logDensity}) - std::log(2.0) + std::log(squatOdds);
  logs[static_cast<std::size_t>(Kind::other)] -= std::log(rarerOthers);
  for (std::size_t k = 0; k < kindCount; ++k)
    logs[k] = trust * (logs[k] + densities.logReach(static_cast<Kind>(k), event));
  auto& ofFlat = logs[static_cast<std::size_t>(Kind::flat)];
  if (std::isfinite(ofFlat)) judgement.flatProbability = std::exp(ofFlat - logSum(logs));
  ofFlat = -std::numeric_limits<double>::infinity();
  const double all = logSum(logs);
  std::array<double, kindCount> probability{}, weighed{};
  for (std::size_t k = 0; k < kindCount; ++k) weighed[k] = probability[k] = std::exp(logs[k] - all);
  auto& missed = weighed[static_cast<std::size_t>(Kind::squat)];
  missed = 0;
  for (std::size_t s = 0; s < size.severity.size(); ++s)
    missed += missedCost[s] * size.severity[s] * probability[static_cast<std::size_t>(Kind::squat)];
  const auto best = static_cast<std::size_t>(std::max_element(weighed.begin(), weighed.end()) - weighed.begin());
  judgement.kind = static_cast<Kind>(best);
  judgement.sureness = probability[best];
  judgement.squatProbability = probability[static_cast<std::size_t>(Kind::squat)];
  judgement.otherProbability = probability[static_cast<std::size_t>(Kind::other)];
}

// A squat of known size is among the passages of the own vehicle: it does not count twice.
Belief Judge::beliefOf(const Judgement& judgement, const std::optional<Label>& label) const {
  if (!label) return {judgement.squatProbability * (1 - judgement.nothing), {}};
  const bool counts = label->kind == Kind::squat && !label->hasSize();
  return {counts ? 1.0 : 0.0, label->severityBy(options_.limits)};
}

// The vehicle follows from what is a squat, and that from the vehicle: in turn, over the events that are squats most
// surely, more of them than the vehicle is then estimated from.
std::optional<Vehicle> Judge::vehicleOf(const std::vector<EventFeatures>& events,
                                        const std::vector<std::optional<Label>>& labels,
                                        std::vector<Judgement> judgements, const SizePosterior& posterior,
                                        const KindDensity& densities, ThreadTeam& team, Monitor& monitor) const {
  constexpr int passes = 3;
  constexpr double atRest = 0.01;  // of the probabilities
  const auto beliefAt = [&](std::size_t i) {
    return beliefOf(judgements[i], labels.empty() ? std::nullopt : labels[i]);
  };
  const auto few = likeliestSquats(events.size(), [&](std::size_t i) { return beliefAt(i).squat; });
  std::vector<EventFeatures> likely;
  for (const auto i : few) likely.push_back(events[i]);
  std::vector<Belief> beliefs(few.size(), Belief{0, {}});
  std::optional<Vehicle> vehicle;
  std::optional<BandValues> start;
  for (int pass = 0; pass < passes; ++pass) {
    double change = 0;
    for (std::size_t k = 0; k < few.size(); ++k) {
      const auto belief = beliefAt(few[k]);
      change = std::max(change, std::abs(belief.squat - beliefs[k].squat));
      beliefs[k] = belief;
    }
    if (pass > 0 && change < atRest) break;
    vehicle = posterior.vehicleOf(likely, beliefs, own_, start, team, monitor);
    if (!vehicle) return std::nullopt;
    start = vehicle->mean;
    if (pass + 1 == passes) break;
    const bool isDone = forEachUnlessCancelled(team, monitor, few.size(), [&](std::size_t k) {
      const auto size = posterior.sizeOf(likely[k], beliefs[k].severity, *vehicle);
      takeKind(likely[k], *vehicle, size, densities, judgements[few[k]]);
    });
    if (!isDone) return std::nullopt;
  }
  return vehicle;
}

std::vector<Judgement> Judge::judge(const std::vector<EventFeatures>& events) const {
  ThreadTeam alone(1);
  Monitor none;
  return *judge(events, {}, alone, none);
}

std::optional<std::vector<Judgement>> Judge::judge(const std::vector<EventFeatures>& events,
                                                   const std::vector<std::optional<Label>>& labels, ThreadTeam& team,
                                                   Monitor& monitor) const {
  const auto vehicles = vehicleWeights(events, team, monitor);
  if (!vehicles) return std::nullopt;
  std::vector<Judgement> judgements(events.size());
  const bool isWeighed = forEachUnlessCancelled(team, monitor, events.size(),
                                                [&](std::size_t i) { judgements[i] = weigh(events[i], *vehicles); });
  if (!isWeighed) return std::nullopt;
  if (!sizes_.isKnown() || events.empty()) return judgements;
  const SizePosterior posterior(sizes_, possible_->squats, events, team, monitor);
  const KindDensity densities(sizes_, examples_, *possible_, events, team, monitor);
  if (monitor.cancelled()) return std::nullopt;
  const auto vehicle = vehicleOf(events, labels, judgements, posterior, densities, team, monitor);
  if (!vehicle) return std::nullopt;
  const auto known = posterior.vehicleOf({}, {}, own_, {}, team, monitor);
  if (!known) return std::nullopt;
  const double axleBox = axleBoxProbability(vehicle->mean - known->mean, sizes_.betweenVehicles());
  const auto judgeOne = [&](std::size_t i) {
    const auto belief = beliefOf(judgements[i], labels.empty() ? std::nullopt : labels[i]);
    const auto size = posterior.sizeOf(events[i], belief.severity, *vehicle);
    takeKind(events[i], *vehicle, size, densities, judgements[i]);
    takeDoubt(events[i], axleBox, judgements[i]);
    takeSize(size, judgements[i]);
  };
  const auto report = reportingTo(monitor, events.size());
  if (!forEachUnlessCancelled(team, monitor, events.size(), judgeOne, report)) return std::nullopt;
  return judgements;
}

}  // namespace squat::detection
