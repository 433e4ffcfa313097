#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "detection/Examples.h"
#include "detection/KindDensity.h"
#include "detection/LogSum.h"

namespace squat::detection {
namespace {

constexpr double sharedEvidence = 0.5;  // events of a record are not independent looks at its vehicle
constexpr double minimumVehicleWeight = 0.02;
constexpr std::size_t kinds = 6;
// Ahead of any event, to one of each other kind: a squat that is missed breaks the rail, a joint called a squat is
// looked at once. With 10 to 40, all of 600 squats of twenty vehicles were called so, with 2 or 3 of their 80 joints
// and welds; with 3, four severe squats were called joints or welds.
constexpr double squatOdds = 10;

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
constexpr std::size_t groups = 3 + kinds;
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
    prior_.push_back(std::log(share * std::max(examples_[i].weight, 1e-9)) - std::log(static_cast<double>(withGroup)) -
                     std::log(static_cast<double>(row[vehicleOf_[i]])));
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

std::vector<double> Judge::vehicleWeights(const std::vector<std::vector<double>>& likelihoods) const {
  std::vector<double> logs(vehicles_.size(), 0.0);
  for (const auto& event : likelihoods) {
    std::vector<std::vector<double>> ofVehicle(vehicles_.size());
    for (std::size_t i = 0; i < event.size(); ++i) ofVehicle[vehicleOf_[i]].push_back(event[i]);
    const double all = logSum(event) - std::log(static_cast<double>(vehicles_.size()));
    for (std::size_t v = 0; v < vehicles_.size(); ++v)  // a single event convinces nobody: at most a factor of e^3
      logs[v] += sharedEvidence * std::clamp(logSum(ofVehicle[v]) - all, -3.0, 3.0);
  }
  const double sum = logSum(logs), n = static_cast<double>(vehicles_.size());
  for (auto& value : logs) value = std::exp(value - sum) * (1 - minimumVehicleWeight) + minimumVehicleWeight / n;
  return logs;
}

Judgement Judge::weigh(const EventFeatures& event, const std::vector<double>& likelihoods,
                       const std::vector<double>& vehicles) const {
  std::vector<double> logs = likelihoods;
  for (std::size_t i = 0; i < logs.size(); ++i)
    logs[i] += std::log(vehicles[vehicleOf_[i]] * static_cast<double>(vehicles_.size()));
  const double nothing = logNothing(event), some = logSum(logs);
  Judgement judgement;
  judgement.nothing = 1 / (1 + std::exp(some - nothing));
  std::array<double, kinds> ofKind{};
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
  judgement.length = quantile(lengths, 0.5), judgement.lengthLow = quantile(lengths, 0.05);
  judgement.lengthHigh = quantile(lengths, 0.95);
  judgement.depth = quantile(depths, 0.5), judgement.depthLow = quantile(depths, 0.05);
  judgement.depthHigh = quantile(depths, 0.95);
  return judgement;
}

void Judge::takeKind(const EventFeatures& event, const Vehicle& vehicle, double asSquat, KindDensity& densities,
                     Judgement& judgement) const {
  std::vector<double> logs;
  for (std::size_t k = 0; k < kinds; ++k) {
    const auto kind = static_cast<Kind>(k);
    logs.push_back(kind == Kind::squat ? asSquat + std::log(squatOdds) : densities.of(kind, event, vehicle));
  }
  const double all = logSum(logs);
  const auto best = std::max_element(logs.begin(), logs.end());
  judgement.kind = static_cast<Kind>(best - logs.begin());
  judgement.sureness = std::exp(*best - all);
  judgement.squatProbability = std::exp(logs[static_cast<std::size_t>(Kind::squat)] - all);
}

// A squat of known size is among the passages of the own vehicle: it does not count twice.
Belief Judge::beliefOf(const Judgement& judgement, const std::optional<Label>& label) const {
  if (!label) return {judgement.squatProbability * (1 - judgement.nothing), {}};
  const bool counts = label->kind == Kind::squat && !label->hasSize();
  return {counts ? 1.0 : 0.0, label->severityBy(options_.limits)};
}

void Judge::takeSizes(const std::vector<EventFeatures>& events, const std::vector<std::optional<Label>>& labels,
                      std::vector<Judgement>& judgements) const {
  constexpr int passes = 3;        // the vehicle follows from what is a squat, and that from the vehicle
  constexpr double atRest = 0.01;  // of the probabilities
  KindDensity densities(sizes_, examples_, *possible_);
  SquatSizes sizes;
  std::optional<BandValues> start;
  std::vector<Belief> beliefs(events.size(), Belief{0, {}});
  for (int pass = 0; pass < passes; ++pass) {
    double change = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
      const auto belief = beliefOf(judgements[i], labels.empty() ? std::nullopt : labels[i]);
      change = std::max(change, std::abs(belief.squat - beliefs[i].squat));
      beliefs[i] = belief;
    }
    if (pass > 0 && change < atRest) break;
    sizes = squatSizes(sizes_, possible_->squats, events, beliefs, own_, start);
    start = sizes.vehicle.mean;
    for (std::size_t i = 0; i < events.size(); ++i)
      takeKind(events[i], sizes.vehicle, sizes.each[i].logDensity, densities, judgements[i]);
  }
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto& size = sizes.each[i];
    auto& judgement = judgements[i];
    const auto likeliest = std::max_element(size.severity.begin(), size.severity.end());
    judgement.severity = static_cast<Severity>(likeliest - size.severity.begin());
    judgement.severitySureness = *likeliest;
    judgement.length = size.length, judgement.lengthLow = size.lengthLow, judgement.lengthHigh = size.lengthHigh;
    judgement.depth = size.depth, judgement.depthLow = size.depthLow, judgement.depthHigh = size.depthHigh;
  }
}

std::vector<Judgement> Judge::judge(const std::vector<EventFeatures>& events,
                                    const std::vector<std::optional<Label>>& labels) const {
  std::vector<std::vector<double>> likelihoods;
  for (const auto& event : events) likelihoods.push_back(logLikelihoods(event));
  const auto vehicles = vehicleWeights(likelihoods);
  std::vector<Judgement> judgements;
  for (std::size_t i = 0; i < events.size(); ++i) judgements.push_back(weigh(events[i], likelihoods[i], vehicles));
  if (sizes_.isKnown() && !events.empty()) takeSizes(events, labels, judgements);
  return judgements;
}

}  // namespace squat::detection
