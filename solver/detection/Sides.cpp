#include "detection/Sides.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace squat::detection {
namespace {

constexpr double samePlace = 0.3;  // [m] between the events of two channels

void judgeEvents(std::vector<Event>& events, RailSide own, const AxleSides& sides) {
  for (auto& event : events) {
    if (!event.arrival || event.extent > 0) continue;
    auto arrival = *event.arrival;
    if (own == RailSide::right) {
      std::swap(arrival.energy[0], arrival.energy[1]);
      std::swap(arrival.noise[0], arrival.noise[1]);
    }
    event.side = sides.judge(arrival, event.kind);
  }
}

// Events of one channel by where they are, those with a side alone.
std::multimap<double, std::size_t> byPlace(const std::vector<Event>& events) {
  std::multimap<double, std::size_t> places;
  for (std::size_t i = 0; i < events.size(); ++i)
    if (events[i].side) places.emplace(events[i].travelled, i);
  return places;
}

// Takes the nearest place out of the list.
std::optional<std::size_t> takeNearest(std::multimap<double, std::size_t>& places, double travelled) {
  auto nearest = places.end();
  double distance = samePlace;
  for (auto at = places.lower_bound(travelled - distance); at != places.end() && at->first < travelled + samePlace;
       ++at)
    if (const double apart = std::abs(at->first - travelled); apart < distance) distance = apart, nearest = at;
  if (nearest == places.end()) return std::nullopt;
  const auto index = nearest->second;
  places.erase(nearest);
  return index;
}

void removeMarked(std::vector<Event>& events, const std::vector<bool>& isMarked) {
  std::vector<Event> kept;
  for (std::size_t i = 0; i < events.size(); ++i)
    if (!isMarked[i]) kept.push_back(std::move(events[i]));
  events = std::move(kept);
}

// Gives pairs the side of the stronger, and removes crosstalk.
void joinPairs(std::vector<Event>& left, std::vector<Event>& right) {
  auto places = byPlace(right);
  std::vector<bool> notOnLeft(left.size(), false), notOnRight(right.size(), false);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i].side) continue;
    const auto partner = takeNearest(places, left[i].travelled);
    if (!partner) continue;
    auto& other = right[*partner];
    const auto judged = left[i].score >= other.score ? *left[i].side : *other.side;
    left[i].side = other.side = judged;
    if (judged.side() == RailSide::right) notOnLeft[i] = !left[i].label;
    if (judged.side() == RailSide::left) notOnRight[*partner] = !other.label;
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
    joinPairs(left, right);
  }
}

}  // namespace squat::detection
