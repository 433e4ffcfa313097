#include "detection/Sides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace squat::detection {
namespace {

constexpr double samePlace = 0.3;  // [m] between the events of two channels
constexpr double sureSide = 0.8;   // probability of a side below which no event is left out for it

void judgeEvents(std::vector<Event>& events, RailSide own, const AxleSides& sides) {
  for (auto& event : events) {
    if (!event.arrival || event.judgement.axleBox < 0.5) continue;  // no axle box: no side of it
    auto arrival = *event.arrival;
    if (own == RailSide::right) {
      std::swap(arrival.energy[0], arrival.energy[1]);
      std::swap(arrival.noise[0], arrival.noise[1]);
    }
    event.side = sides.judge(arrival, event.kind);
  }
}

struct Pair {
  std::size_t left = 0, right = 0;
  double apart = 0;  // [m]
};

// Events of both channels that are one place, the closest first; each in one pair alone.
std::vector<Pair> pairsOf(const std::vector<Event>& left, const std::vector<Event>& right) {
  std::multimap<double, std::size_t> places;
  for (std::size_t i = 0; i < right.size(); ++i)
    if (right[i].side) places.emplace(right[i].travelled, i);
  std::vector<Pair> near, pairs;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i].side) continue;
    const double here = left[i].travelled;
    for (auto at = places.lower_bound(here - samePlace); at != places.end() && at->first < here + samePlace; ++at)
      near.push_back({i, at->second, std::abs(at->first - here)});
  }
  std::stable_sort(near.begin(), near.end(), [](const Pair& a, const Pair& b) { return a.apart < b.apart; });
  std::vector<bool> leftTaken(left.size(), false), rightTaken(right.size(), false);
  for (const auto& pair : near) {
    if (leftTaken[pair.left] || rightTaken[pair.right]) continue;
    leftTaken[pair.left] = rightTaken[pair.right] = true;
    pairs.push_back(pair);
  }
  return pairs;
}

// The event of a pair that is crosstalk, if one surely is; the other one gets the side that the surer of both has.
// Where each says as surely that it is of its own rail, there are two defects.
std::optional<RailSide> crosstalkOf(Event& left, Event& right) {
  const auto judged = left.side->sureness() >= right.side->sureness() ? *left.side : *right.side;
  if (judged.sureness() < sureSide || judged.side() == RailSide::both) return std::nullopt;
  const auto own = judged.side() == RailSide::left ? RailSide::right : RailSide::left;  // of the crosstalk's channel
  auto &kept = own == RailSide::right ? left : right, &other = own == RailSide::right ? right : left;
  if (other.side->side() == own && other.side->sureness() >= sureSide) return std::nullopt;
  kept.side = judged;
  return own;
}

void removeMarked(std::vector<Event>& events, const std::vector<bool>& isMarked) {
  std::vector<Event> kept;
  for (std::size_t i = 0; i < events.size(); ++i)
    if (!isMarked[i]) kept.push_back(std::move(events[i]));
  events = std::move(kept);
}

// A label speaks for both events of a pair; two labels are two defects.
void joinPairs(std::vector<Event>& left, std::vector<Event>& right) {
  std::vector<bool> notOnLeft(left.size(), false), notOnRight(right.size(), false);
  for (const auto& pair : pairsOf(left, right)) {
    auto &one = left[pair.left], &other = right[pair.right];
    if (one.label && other.label) continue;
    if (one.label || other.label) {
      (one.label ? notOnRight[pair.right] : notOnLeft[pair.left]) = true;
      continue;
    }
    const auto crosstalk = crosstalkOf(one, other);
    if (crosstalk) (*crosstalk == RailSide::right ? notOnRight[pair.right] : notOnLeft[pair.left]) = true;
  }
  removeMarked(left, notOnLeft);
  removeMarked(right, notOnRight);
}

}  // namespace

void judgeSides(RecordDetection& detection, const AxleSides& sides) {
  if (!sides.isKnown()) return;
  for (const auto& axle : detection.axles) {
    auto &left = detection.channels[axle.left].events, &right = detection.channels[axle.right].events;
    judgeEvents(left, RailSide::left, sides);
    judgeEvents(right, RailSide::right, sides);
    for (auto* events : {&left, &right})
      for (auto& event : *events)
        event.axle = detection.channels[axle.left].name + ", " + detection.channels[axle.right].name;
    joinPairs(left, right);
  }
}

}  // namespace squat::detection
