#include "detection/Surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace squat::detection {
namespace {

constexpr double positionTolerance = 0.06;  // [m] of a strike: half of what an event's place scatters by
constexpr std::size_t minimumStrikes = 4;

double strengthOf(const Event& event) {
  double sum = 0;
  for (std::size_t b = 1; b < bandCount; ++b) sum += std::max(0.0, event.features.energy[b] - event.features.noise[b]);
  return sum;
}

// For each event, the next one that lies one or two circumferences behind it; the number of events where there is none.
std::vector<std::size_t> followers(const std::vector<Event>& events, double circumference) {
  std::vector<std::size_t> next(events.size(), events.size());
  for (std::size_t i = 0; i < events.size(); ++i)
    for (int turns = 1; turns <= 2 && next[i] == events.size(); ++turns)
      for (std::size_t k = i + 1; k < events.size(); ++k) {
        const double apart = events[k].travelled - events[i].travelled - turns * circumference;
        if (apart > positionTolerance) break;
        if (apart > -positionTolerance) next[i] = k;
      }
  return next;
}

// The chains of strikes, each as indices of events.
std::vector<std::vector<std::size_t>> chains(const std::vector<Event>& events, double circumference,
                                             std::size_t least = minimumStrikes) {
  const auto next = followers(events, circumference);
  std::vector<bool> isTaken(events.size(), false);
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (isTaken[i]) continue;
    std::vector<std::size_t> chain;
    for (std::size_t k = i; k < events.size() && !isTaken[k]; k = next[k]) {
      isTaken[k] = true;
      chain.push_back(k);
    }
    if (chain.size() >= least) found.push_back(std::move(chain));
  }
  return found;
}

std::size_t strikes(const std::vector<Event>& events, double circumference) {
  std::size_t sum = 0;
  for (const auto& chain : chains(events, circumference)) sum += chain.size();
  return sum;
}

double likeliestCircumference(const std::vector<Event>& events, const SurroundingsOptions& options) {
  if (options.circumference > 0) return options.circumference;
  double best = 0;
  std::size_t maximum = minimumStrikes;
  // Steps that a chain of four does not miss.
  for (double length = options.minimumCircumference; length <= options.largestCircumference; length += 0.01) {
    const auto count = strikes(events, length);
    if (count > maximum || (best == 0 && count >= maximum)) best = length, maximum = count;
  }
  return best;
}

// That a chain is a flat: by chance half as likely with each strike, and as its strikes look.
double surenessOf(const std::vector<Event>& events, const std::vector<std::size_t>& chain) {
  double odds = static_cast<double>(chain.size()) * std::log(2.0);
  for (const auto i : chain) {
    const double like = std::clamp(events[i].judgement.flatProbability, 1e-9, 1 - 1e-9);
    odds += std::clamp(std::log(like / (1 - like)), -0.25, 0.5);
  }
  return 1 - std::exp(-odds);
}

double medianStrength(const std::vector<Event>& events, const std::vector<std::size_t>& chain) {
  std::vector<double> values;
  for (const auto i : chain) values.push_back(strengthOf(events[i]));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double markFlats(std::vector<Event>& events, const SurroundingsOptions& options) {
  const double circumference = likeliestCircumference(events, options);
  if (!(circumference > 0)) return 0;
  constexpr std::size_t leastStrikes = 3;
  // Three strikes whose shape tells nothing do not reach it, nor four that look unlike a flat.
  constexpr double leastSureness = 0.88;
  auto found = chains(events, circumference, leastStrikes);
  std::erase_if(found, [&](const auto& chain) { return surenessOf(events, chain) < leastSureness; });
  double turns = 0, way = 0;
  for (const auto& chain :
       found)  // link by link: over many turns the first guess of the length would count some too many
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const double length = events[chain[k]].travelled - events[chain[k - 1]].travelled;
      way += length, turns += std::round(length / circumference);
    }
  for (const auto& chain : found) {
    const double middle = medianStrength(events, chain);
    for (const auto i : chain) {
      if (strengthOf(events[i]) > 4 * middle) continue;
      events[i].kind = Kind::flat;
      events[i].sureness = surenessOf(events, chain);
      char text[64];
      std::snprintf(text, sizeof text, "repeats every %.2f m, %zu times", way / turns, chain.size());
      events[i].reason = text;
    }
  }
  return turns > 0 ? way / turns : 0;
}

std::vector<std::size_t> strikesOfFlats(const std::vector<Event>& events, const SurroundingsOptions& options) {
  constexpr std::size_t longChain = 10;
  std::vector<std::size_t> strikes;
  const double circumference = likeliestCircumference(events, options);
  if (!(circumference > 0)) return strikes;
  for (const auto& chain : chains(events, circumference))
    if (chain.size() >= longChain) strikes.insert(strikes.end(), chain.begin(), chain.end());
  return strikes;
}

void markCorrugation(std::vector<Event>& events) {
  constexpr double shortest = 2.0;  // [m] that are loud: a squat and its ringing take half a metre, a weld one
  for (auto& event : events) {
    if (event.features.reach < shortest) continue;
    event.kind = Kind::corrugation;
    event.sureness = std::min(0.99, event.features.reach / (event.features.reach + 1.0));
    char text[64];
    std::snprintf(text, sizeof text, "loud over %.2g m", event.features.reach);
    event.reason = text;
  }
}

}  // namespace squat::detection
