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
// Of log10 of an energy without noise: samples that are 0.1 to 0.2 ms apart do not meet the onset exactly.
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

// Of log10 of the energy of the other box, given that of the box `here`: the ratio is integrated over, since what noise
// leaves of a weak signal is not normal.
double AxleSides::density(const FirstArrival& arrival, std::size_t here, const Ratio& ratio) {
  constexpr int steps = 80;
  constexpr double reach = 4;  // spreads on both sides
  const std::size_t other = 1 - here;
  const double noiseHere = arrival.noise[here], noise = arrival.noise[other];
  const double own = std::max(arrival.energy[here] - noiseHere, 0.1 * noiseHere);
  // The energy here is known as well as its noise lets it be.
  const double unsure =
      std::sqrt((2 * noiseHere * noiseHere + 4 * own * noiseHere) / degreesOfNoise) / (own * std::numbers::ln10);
  const double spread = std::hypot(ratio.spread, unsure);
  const double seen = std::log10(std::max(arrival.energy[other], 1e-6 * arrival.energy[here]));
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double away = reach * (2.0 * i / steps - 1);  // in spreads
    const double signal = own * std::pow(10, -(ratio.mean + spread * away)), all = signal + noise;
    const double relative = std::sqrt((2 * noise * noise + 4 * signal * noise) / degreesOfNoise) / all;
    sum += normalDensity(away, 1) * normalDensity(seen - std::log10(all), std::hypot(leastSpread, relative / std::numbers::ln10));
  }
  return sum * 2 * reach / steps;
}

SideJudgement AxleSides::judge(const FirstArrival& arrival, Kind kind) const {
  const double both = priorOfBoth(kind);
  SideJudgement judgement;
  judgement.probability = {0.5 * (1 - both) * density(arrival, 0, oneRail_),
                           0.5 * (1 - both) * density(arrival, 1, oneRail_),
                           both * 0.5 * (density(arrival, 0, bothRails_) + density(arrival, 1, bothRails_))};
  double sum = 0;
  for (const double each : judgement.probability) sum += each;
  for (std::size_t s = 0; s < 3; ++s)
    judgement.probability[s] =
        sum > 0 ? judgement.probability[s] / sum : (s == 2 ? both : 0.5 * (1 - both));  // like nothing: as before
  return judgement;
}

}  // namespace squat::detection
