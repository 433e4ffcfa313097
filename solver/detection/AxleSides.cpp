#include "detection/AxleSides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace squat::detection {
namespace {

// A squat opposite to another one is rare; joints are, and welds often, on both rails.
double priorOfBoth(Kind kind) { return kind == Kind::squat || kind == Kind::flat ? 0.1 : 1.0 / 3; }

// Of noise up to 2 kHz over 1.5 ms.
constexpr double degreesOfNoise = 6;
// Of log10 of an energy without noise: samples that are 0.1 to 0.25 ms apart do not meet the onset exactly.
constexpr double leastSpread = 0.1;

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double spreadOf(const std::vector<double>& values, double mean) {
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double normalDensity(double distance, double spread) {
  return std::exp(-0.5 * distance * distance / (spread * spread)) / (spread * std::sqrt(2 * std::numbers::pi));
}

// Of log10 of the energy that a box has measured, where `signal` is what it feels: with noise N of n degrees of
// freedom, a signal S has the variance (2 N^2 + 4 S N) / n.
double seenDensity(const FirstArrival& arrival, std::size_t box, double signal) {
  const double noise = arrival.noise[box], all = signal + noise;
  const double relative = std::sqrt((2 * noise * noise + 4 * signal * noise) / degreesOfNoise) / all;
  const double seen = std::max(arrival.energy[box], 1e-300);
  return normalDensity(std::log10(seen / all), std::hypot(leastSpread, relative / std::numbers::ln10));
}

}  // namespace

std::string toText(RailSide side) {
  return side == RailSide::left ? "left" : side == RailSide::right ? "right" : "both";
}

RailSide SideJudgement::side() const {
  return static_cast<RailSide>(std::max_element(probability.begin(), probability.end()) - probability.begin());
}

double SideJudgement::sureness() const { return *std::max_element(probability.begin(), probability.end()); }

AxleSides::AxleSides(const std::vector<Example>& examples) {
  std::map<std::string, std::vector<std::array<double, 2>>> vehicles;
  std::vector<double> one, both;
  for (const auto& example : examples) {
    if (!example.arrival) continue;
    vehicles[example.vehicle].push_back(*example.arrival);
    one.push_back(std::log10((*example.arrival)[0] / (*example.arrival)[1]));
  }
  for (const auto& [name, own] : vehicles)
    for (std::size_t left = 0; left < own.size(); ++left)
      for (std::size_t right = 0; right < own.size(); ++right)
        if (left != right) both.push_back(std::log10((own[left][0] + own[right][1]) / (own[right][0] + own[left][1])));
  known_ = one.size() >= 10 && vehicles.size() >= 3;
  if (!known_) return;
  oneRail_.mean = meanOf(one);
  oneRail_.spread = spreadOf(one, oneRail_.mean);
  bothRails_ = {0, spreadOf(both, 0)};  // each pair stands in both orders
}

// Of log10 of both energies. What the struck box feels may be anything, each decade as likely, within what any box has
// measured: integrated over it, and over the ratio.
double AxleSides::density(const FirstArrival& arrival, std::size_t struck, const Ratio& ratio) {
  constexpr int sources = 40, ratios = 32;
  constexpr double lowest = -4, highest = 0.5;  // log10, by the larger energy
  constexpr double reach = 4;                   // spreads on both sides of the ratio's mean
  const double largest = std::max(arrival.energy[0], arrival.energy[1]);
  std::array<double, ratios + 1> share{}, weight{};
  for (int k = 0; k <= ratios; ++k) {
    const double away = reach * (2.0 * k / ratios - 1);
    share[k] = std::pow(10, -(ratio.mean + ratio.spread * away)), weight[k] = normalDensity(away, 1);
  }
  double sum = 0;
  for (int i = 0; i <= sources; ++i) {
    const double source = largest * std::pow(10, lowest + (highest - lowest) * i / sources);
    double other = 0;
    for (int k = 0; k <= ratios; ++k) other += weight[k] * seenDensity(arrival, 1 - struck, source * share[k]);
    sum += seenDensity(arrival, struck, source) * other;
  }
  return sum;
}

SideJudgement AxleSides::judge(const FirstArrival& arrival, Kind kind) const {
  const double both = priorOfBoth(kind);
  SideJudgement judgement;
  judgement.probability = {0.5 * (1 - both) * density(arrival, 0, oneRail_),
                           0.5 * (1 - both) * density(arrival, 1, oneRail_),
                           both * 0.5 * (density(arrival, 0, bothRails_) + density(arrival, 1, bothRails_))};
  double sum = 0;
  for (const double each : judgement.probability) sum += each;
  // Like nothing that is known: what was known before.
  if (!(sum > 0)) judgement.probability = {0.5 * (1 - both), 0.5 * (1 - both), both}, sum = 1;
  for (double& each : judgement.probability) each /= sum;
  return judgement;
}

}  // namespace squat::detection
