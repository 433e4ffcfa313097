#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "detection/Examples.h"

namespace squat::detection {
namespace {

constexpr double speedSpread = 0.15;     // of the logarithm of the speed: what two speeds have in common
constexpr double sharedEvidence = 0.5;   // events of a record are not independent looks at its vehicle
constexpr double leastVehicleWeight = 0.02;
constexpr std::size_t kinds = 6;

// Logarithm of a normal density of log10 of the energy `seen` where `signal` and noise are expected.
double logDensity(double seen, double signal, double noise, double freedom, double spread) {
  const double expected = signal + noise;
  if (!(expected > 0) || !(seen > 0)) return seen > 0 ? -1e3 : 0;
  const double scatter = std::sqrt(2 * noise * noise + 4 * signal * noise) / std::sqrt(freedom);
  const double ofNoise = scatter / expected / std::log(10.0), ofSignal = spread * signal / expected;
  const double variance = ofNoise * ofNoise + ofSignal * ofSignal + 1e-4;
  const double distance = std::log10(seen / expected);
  return -0.5 * distance * distance / variance - 0.5 * std::log(variance);
}

double logSum(const std::vector<double>& logs) {
  if (logs.empty()) return -std::numeric_limits<double>::infinity();
  const double largest = *std::max_element(logs.begin(), logs.end());
  if (!std::isfinite(largest)) return largest;
  double sum = 0;
  for (const double value : logs) sum += std::exp(value - largest);
  return largest + std::log(sum);
}

struct Weighted {
  double value, weight;
};

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

Judge::Judge(std::vector<Example> examples, JudgementOptions options)
    : examples_(std::move(examples)), options_(options) {
  std::vector<std::vector<std::size_t>> count(kinds);  // of examples, a kind and vehicle
  for (const auto& example : examples_) {
    const auto found = std::find(vehicles_.begin(), vehicles_.end(), example.vehicle);
    vehicleOf_.push_back(static_cast<std::size_t>(found - vehicles_.begin()));
    if (found == vehicles_.end()) vehicles_.push_back(example.vehicle);
  }
  for (auto& row : count) row.assign(vehicles_.size(), 0);
  for (std::size_t i = 0; i < examples_.size(); ++i)
    ++count[static_cast<std::size_t>(examples_[i].kind)][vehicleOf_[i]];
  for (std::size_t i = 0; i < examples_.size(); ++i) {
    const auto& row = count[static_cast<std::size_t>(examples_[i].kind)];
    const auto ofKind = std::count_if(row.begin(), row.end(), [](std::size_t n) { return n > 0; });
    prior_.push_back(std::log(std::max(examples_[i].weight, 1e-9)) - std::log(static_cast<double>(ofKind)) -
                     std::log(static_cast<double>(row[vehicleOf_[i]])));
  }
}

std::vector<double> Judge::logLikelihoods(const EventFeatures& event) const {
  std::vector<double> logs(examples_.size());
  for (std::size_t i = 0; i < examples_.size(); ++i) {
    const auto& example = examples_[i];
    const double ratio = event.speed / example.speed, apart = std::log(ratio) / speedSpread;
    logs[i] = prior_[i] - 0.5 * apart * apart;
    for (std::size_t b = 0; b < bandCount; ++b)
      if (event.freedom[b] > 0)
        logs[i] += logDensity(event.energy[b], example.energy[b] * ratio * ratio, event.noise[b], event.freedom[b],
                              options_.spread);
  }
  return logs;
}

double Judge::logNothing(const EventFeatures& event) const {
  double log = std::log(options_.nothing);
  for (std::size_t b = 0; b < bandCount; ++b)
    if (event.freedom[b] > 0) log += logDensity(event.energy[b], 0, event.noise[b], event.freedom[b], 0);
  return log;
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
  for (auto& value : logs) value = std::exp(value - sum) * (1 - leastVehicleWeight) + leastVehicleWeight / n;
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
    ofSeverity[static_cast<std::size_t>(severityOf(example.length, example.depth, options_.limits))] += weight;
    lengths.push_back({example.length, weight});
    depths.push_back({example.depth, weight});
    offset += weight * example.offset;
  }
  const auto best = std::max_element(ofKind.begin(), ofKind.end());
  judgement.kind = static_cast<Kind>(best - ofKind.begin());
  judgement.sureness = *best;
  judgement.squatProbability = ofKind[static_cast<std::size_t>(Kind::squat)];
  if (!(judgement.squatProbability > 0)) return judgement;
  const auto severity = std::max_element(ofSeverity.begin(), ofSeverity.end());
  judgement.severity = static_cast<Severity>(severity - ofSeverity.begin());
  judgement.severitySureness = *severity / judgement.squatProbability;
  judgement.length = quantile(lengths, 0.5), judgement.lengthLow = quantile(lengths, 0.05);
  judgement.lengthHigh = quantile(lengths, 0.95);
  judgement.depth = quantile(depths, 0.5), judgement.depthLow = quantile(depths, 0.05);
  judgement.depthHigh = quantile(depths, 0.95);
  judgement.offset = offset / judgement.squatProbability;
  return judgement;
}

std::vector<Judgement> Judge::judge(const std::vector<EventFeatures>& events) const {
  std::vector<std::vector<double>> likelihoods;
  for (const auto& event : events) likelihoods.push_back(logLikelihoods(event));
  const auto vehicles = vehicleWeights(likelihoods);
  std::vector<Judgement> judgements;
  for (std::size_t i = 0; i < events.size(); ++i) judgements.push_back(weigh(events[i], likelihoods[i], vehicles));
  return judgements;
}

}  // namespace squat::detection
