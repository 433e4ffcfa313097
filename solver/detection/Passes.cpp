#include "detection/Passes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "signals/Alignment.h"

namespace squat::detection {
namespace {

constexpr double sameLocation = 0.35;  // [m] events of two passes, once moved, that are one
constexpr double largestShift = 10;    // [m] between the counters of two passes

struct Extent {
  double first = 0, last = 0;
};

Extent extentOf(const RecordDetection& detection) {
  Extent extent{1e300, -1e300};
  for (const auto& channel : detection.channels)
    for (const auto& piece : channel.pieces) {
      extent.first = std::min(extent.first, piece.position);
      extent.last = std::max(extent.last, piece.position + pieceLength);
    }
  return extent;
}

bool covers(const Extent& extent, double position) {
  return position >= extent.first - pieceLength && position <= extent.last + pieceLength;
}

std::vector<double> positionsOf(const RecordDetection& detection) {
  std::vector<double> positions;
  for (const auto& channel : detection.channels)
    for (const auto& event : channel.events)
      if (event.kind != Kind::flat) positions.push_back(event.position);
  return positions;
}

// The shift that brings most events of one pass onto those of the other; zero where fewer than two meet.
double shiftOnto(const std::vector<double>& fixed, const std::vector<double>& moved) {
  std::vector<double> shifts;
  for (const double a : fixed)
    for (const double b : moved)
      if (std::abs(a - b) <= largestShift) shifts.push_back(a - b);
  std::sort(shifts.begin(), shifts.end());
  std::size_t best = 1, from = 0, bestFrom = 0;
  for (std::size_t to = 0; to < shifts.size(); ++to) {
    while (shifts[to] - shifts[from] > sameLocation) ++from;
    if (to - from + 1 > best) best = to - from + 1, bestFrom = from;
  }
  if (best < 2) return 0;
  return std::accumulate(shifts.begin() + static_cast<std::ptrdiff_t>(bestFrom),
                         shifts.begin() + static_cast<std::ptrdiff_t>(bestFrom + best), 0.0) /
         static_cast<double>(best);
}

// [m] from where the second event was found to where its signal matches the first's.
double matchedShift(const Event& one, const Event& other) {
  if (one.passage.values.size() < 16 || other.passage.values.size() < 16) return 0;
  const auto passageOf = [](const Event& event) {
    auto passage = signals::passageAtSpeed(event.passage, event.features.speed);
    const double atEvent = passage.position.front() + (event.time - event.passage.start) * event.features.speed;
    for (auto& position : passage.position) position -= atEvent;
    return passage;
  };
  signals::AlignmentOptions options;
  options.before = 0.1, options.after = 0.3;
  options.largestShift = 0.15;
  options.anchor = one.time;
  try {
    const auto aligned = signals::alignInPosition({passageOf(one), passageOf(other)}, options);
    return aligned.correlation[1] > 0.6 ? aligned.impact[1] - aligned.impact[0] : 0;
  } catch (const std::exception&) {
    return 0;  // too short or silent: the positions stay as found
  }
}

struct Found {
  const Event* event;
  std::size_t record;
  double position;  // [m] in the first record's chainage
};

// Events of one channel; or of one wheelset and side, whichever of its boxes has shown them.
bool areOfOneRail(const Event& one, const Event& other) {
  if (one.channel == other.channel) return true;
  return one.side && other.side && one.axle == other.axle && one.side->side() == other.side->side();
}

// Mean of the passes that know it.
std::optional<SideJudgement> meanSide(const std::vector<Found>& group) {
  SideJudgement mean;
  double known = 0;
  for (const auto& found : group)
    if (found.event->side) known += 1;
  if (known == 0) return std::nullopt;
  for (const auto& found : group)
    for (std::size_t s = 0; found.event->side && s < mean.probability.size(); ++s)
      mean.probability[s] += found.event->side->probability[s] / known;
  return mean;
}

CombinedEvent combined(std::vector<Found> group, std::size_t there) {
  std::sort(group.begin(), group.end(), [](const Found& a, const Found& b) { return a.event->score > b.event->score; });
  CombinedEvent result{*group.front().event, {}, 0};
  std::vector<double> positions;
  std::map<Kind, double> kinds;
  std::map<Severity, double> severities;
  for (const auto& found : group) {
    result.records.push_back(found.record);
    positions.push_back(found.position +
                        (&found == &group.front() ? 0 : matchedShift(*group.front().event, *found.event)));
    kinds[found.event->kind] += found.event->sureness;
    severities[found.event->judgement.severity] += found.event->judgement.severitySureness;
  }
  const auto largest = [](const auto& sums) {
    return std::max_element(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  };
  const double n = static_cast<double>(positions.size());
  const double mean = std::accumulate(positions.begin(), positions.end(), 0.0) / n;
  for (const double position : positions) result.scatter = std::max(result.scatter, std::abs(position - mean));
  result.event.position = mean;
  const auto labelled = std::find_if(group.begin(), group.end(), [](const Found& f) { return f.event->label; });
  if (labelled != group.end()) {  // it decides
    result.event.label = labelled->event->label, result.event.reason = labelled->event->reason;
    result.event.kind = labelled->event->kind, result.event.sureness = labelled->event->sureness;
    result.event.judgement = labelled->event->judgement;
  } else {
    result.event.kind = largest(kinds)->first;
    result.event.sureness = largest(kinds)->second / n;
    const auto severity = largest(severities)->first;
    const auto judged = std::find_if(group.begin(), group.end(),
                                     [severity](const Found& f) { return f.event->judgement.severity == severity; });
    result.event.judgement = judged->event->judgement;  // so that length and depth agree with the severity
  }
  result.event.side = meanSide(group);
  result.event.passes = result.records.size();
  result.event.passesThere = std::max(there, result.records.size());
  return result;
}

}  // namespace

std::vector<double> shiftsOntoFirst(const std::vector<RecordDetection>& detections) {
  std::vector<double> shifts(detections.size(), 0.0);
  if (detections.empty()) return shifts;
  const auto fixed = positionsOf(detections.front());
  for (std::size_t r = 1; r < detections.size(); ++r) shifts[r] = shiftOnto(fixed, positionsOf(detections[r]));
  return shifts;
}

std::size_t passesAt(const std::vector<RecordDetection>& detections, const std::vector<double>& shifts,
                     double position) {
  std::size_t passes = 0;
  for (std::size_t r = 0; r < detections.size(); ++r) passes += covers(extentOf(detections[r]), position - shifts[r]);
  return passes;
}

std::vector<CombinedEvent> combine(const std::vector<RecordDetection>& detections) {
  const auto shifts = shiftsOntoFirst(detections);
  std::vector<Found> all;
  std::vector<Extent> extents;
  for (std::size_t r = 0; r < detections.size(); ++r) {
    const double shift = shifts[r];
    auto extent = extentOf(detections[r]);
    extents.push_back({extent.first + shift, extent.last + shift});
    for (const auto& channel : detections[r].channels)
      for (const auto& event : channel.events) all.push_back({&event, r, event.position + shift});
  }
  std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.position < b.position; });
  std::vector<CombinedEvent> result;
  std::vector<bool> isTaken(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (isTaken[i]) continue;
    std::vector<Found> group{all[i]};
    for (std::size_t k = i + 1; k < all.size() && all[k].position - all[i].position < sameLocation; ++k) {
      const bool isOther =
          std::none_of(group.begin(), group.end(), [&](const Found& f) { return f.record == all[k].record; });
      if (isTaken[k] || !isOther || !areOfOneRail(*all[k].event, *all[i].event)) continue;
      isTaken[k] = true;
      group.push_back(all[k]);
    }
    const auto there = std::count_if(extents.begin(), extents.end(),
                                     [&](const Extent& extent) { return covers(extent, all[i].position); });
    result.push_back(combined(std::move(group), static_cast<std::size_t>(there)));
  }
  return result;
}

}  // namespace squat::detection
