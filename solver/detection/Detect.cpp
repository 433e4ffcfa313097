#include "detection/Detect.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <future>

#include "core/Errors.h"
#include "core/ThreadTeam.h"
#include "detection/BackgroundSections.h"
#include "detection/BandPower.h"
#include "detection/FirstArrival.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

constexpr double noiseProbability = 0.5;  // above it a candidate is dropped

using Clock = std::chrono::steady_clock;

// The segments under way, each computed on a thread of its own, taken in their order.
class Pipeline {
 public:
  Pipeline(RecordDetection& result, const DetectOptions& options)
      : result_(result),
        threshold_(options.threshold),
        maximum_(static_cast<std::size_t>(threadCount(options.threads))) {}

  void add(std::vector<Segment> segments) {
    for (auto& segment : segments) {
      while (underWay_.size() >= maximum_) takeFirst();
      underWay_.push_back(
          std::async(std::launch::async, [threshold = threshold_, axles = result_.axles, segment = std::move(segment)] {
            std::vector<SegmentEvents> found;
            for (std::size_t c = 0; c < segment.channels.size(); ++c)
              found.push_back(segmentEvents(segment, c, threshold, otherChannel(axles, c)));
            return found;
          }));
    }
  }
  void finish() {
    while (!underWay_.empty()) takeFirst();
  }

 private:
  void takeFirst() {
    auto found = underWay_.front().get();
    underWay_.pop_front();
    for (std::size_t c = 0; c < found.size(); ++c) {
      auto& channel = result_.channels[c];
      for (auto& event : found[c].events) channel.events.push_back(std::move(event));
      channel.pieces.insert(channel.pieces.end(), found[c].pieces.begin(), found[c].pieces.end());
      channel.waves.insert(channel.waves.end(), found[c].waves.begin(), found[c].waves.end());
    }
  }

  RecordDetection& result_;
  double threshold_;
  std::size_t maximum_;
  std::deque<std::future<std::vector<SegmentEvents>>> underWay_;
};

void takeLabel(Event& event, const SeverityLimits& limits) {
  const auto& label = *event.label;
  event.kind = event.judgement.kind = label.kind;
  event.sureness = event.judgement.sureness = 1;
  event.reason = "as labelled";
  const auto severity = label.severityBy(limits);
  if (!severity) return;
  event.judgement.severity = *severity;
  event.judgement.severitySureness = 1;
}

// Drops what the background makes more often than the user accepts. Labels stay, and so do strikes of a flat, which no
// background makes: of the metres in which it rings, none tells of the background.
void dropBackground(ChannelDetection& channel, const DetectOptions& options, bool falling) {
  constexpr double ahead = 0.3, ringing = 0.9;  // [m]
  std::vector<Way> struck;
  const auto strikes = strikesOfFlats(channel.events, options.surroundings);
  for (const auto i : strikes) {
    const double at = channel.events[i].position;
    struck.push_back(falling ? Way{at - ringing, at + ahead} : Way{at - ahead, at + ringing});
  }
  channel.background = backgroundSections(channel.pieces, std::move(struck));
  for (auto& event : channel.events)
    if (const auto* own = sectionAt(channel.background, event.position))
      event.falseAlarms = own->tail.alarmsPerKilometre(event.score);
  for (const auto i : strikes) channel.events[i].falseAlarms = 0;
  std::erase_if(channel.events,
                [&](const Event& event) { return !event.label && event.falseAlarms > options.falseAlarms; });
}

bool judgeChannel(ChannelDetection& channel, const Judge& judge, const DetectOptions& options, bool falling,
                  ThreadTeam& team, Monitor& monitor) {
  dropBackground(channel, options, falling);
  std::vector<EventFeatures> features;
  std::vector<std::optional<Label>> labels;
  for (const auto& event : channel.events) features.push_back(event.features), labels.push_back(event.label);
  const auto judged = judge.judge(features, labels, team, monitor);
  if (!judged) return false;
  for (std::size_t i = 0; i < channel.events.size(); ++i) {
    auto& event = channel.events[i];
    const auto& judgement = (*judged)[i];
    event.judgement = judgement;
    if (event.label) event.judgement.nothing = 0;
    event.kind = judgement.kind, event.sureness = judgement.sureness;
    event.position += (falling ? 1 : -1) * judgement.offset;
    event.travelled = falling ? -event.position : event.position;
  }
  std::erase_if(channel.events, [](const Event& event) { return event.judgement.nothing > noiseProbability; });
  markCorrugation(channel.events);
  channel.circumference = markFlats(channel.events, options.surroundings);
  for (auto& event : channel.events)
    if (event.label) takeLabel(event, judge.limits());
  return true;
}

// Of each label the candidate, if there is one.
std::vector<Event*> nearestTo(const std::vector<Label>& labels, RecordDetection& detection, double shift) {
  constexpr double reach = 0.5;  // [m]
  std::vector<Event*> events;
  for (const auto& label : labels) {
    Event* nearest = nullptr;
    double distance = reach;
    for (auto& channel : detection.channels) {
      if (!label.channel.empty() && label.channel != channel.name) continue;
      for (auto& event : channel.events)
        if (const double apart = std::abs(event.position + shift - label.position); apart < distance)
          distance = apart, nearest = &event;
    }
    events.push_back(nearest);
  }
  return events;
}

// Squats ring up to some 900 Hz at least: a record that does not reach that far cannot show them.
void requireRate(const records::RecordLayout& layout) {
  constexpr double lowestRate = 2000;  // [Hz]
  if (layout.rate < lowestRate)
    throw FileError(layout.path, "",
                    "is sampled at " + text::roundedText(layout.rate) +
                        " Hz; squats are looked for up to 900 Hz at least, which needs 2000 Hz",
                    "Check the unit of the time (--time-unit), or record at a higher rate");
}

// A record of which little can be read must not be reported as one without squats.
void requireShare(const RecordDetection& result, std::size_t read, double least) {
  const auto samples = static_cast<double>(result.layout.samples);
  if (result.layout.samples == 0 || static_cast<double>(read) >= least * samples) return;
  const auto share = text::roundedText(100 * static_cast<double>(read) / samples);
  const std::string first = result.faults.empty() ? "" : "; the first that was not: " + result.faults.front().text;
  throw FileError(result.layout.path, "",
                  share + " % of its " + std::to_string(result.layout.samples) + " samples could be read" + first,
                  "Correct the file, choose other columns, or allow it with --least-share 0");
}

// What a record of this rate cannot show.
std::string bandsNotShown(double rate) {
  std::string names;
  for (const auto& band : detectionBands())
    if (!shows(rate, band))
      names += (names.empty() ? "" : ", ") + text::roundedText(band.low) + "-" + text::roundedText(band.high) + " Hz";
  if (names.empty()) return names;
  return "sampling at " + text::roundedText(rate) + " Hz does not show " + names +
         ": kinds, lengths and severities are less sure";
}

}  // namespace

RecordDetection findCandidates(records::RecordStream& stream, const DetectOptions& options, Monitor& monitor) {
  RecordDetection result;
  result.layout = stream.layout();
  requireRate(result.layout);
  for (const auto& channel : result.layout.channels) result.channels.push_back({channel.name, {}, {}, 0});
  result.axles = axlesOf(result.layout, options.axles, result.notes);
  if (!result.axles.empty() && result.layout.rate < lowestRateOfArrivals) {
    result.axles.clear();
    result.notes.assign({"sampling at " + text::roundedText(result.layout.rate) +
                         " Hz is too slow to tell which axle box moves first: events get no side (4000 Hz is enough)"});
  }
  SegmentCutter cutter(result.layout);
  Pipeline pipeline(result, options);
  const auto start = Clock::now();
  records::RecordBlock block;
  std::size_t read = 0;  // samples
  while (!result.cancelled && stream.next(block)) {
    read += block.size();
    for (const double speed : block.speed) result.length += std::max(0.0, speed) / result.layout.rate;
    result.duration += static_cast<double>(block.size()) / result.layout.rate;
    pipeline.add(cutter.push(block));
    Progress progress;
    progress.phase = "detection";
    progress.fraction = stream.fraction();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (progress.fraction > 0.02) progress.remainingSeconds = seconds * (1 / progress.fraction - 1);
    monitor.report(progress);
    result.cancelled = monitor.cancelled();
  }
  if (!result.cancelled) pipeline.add(cutter.finish());
  pipeline.finish();
  for (auto& channel : result.channels) channel.waves = joined(channel.waves);
  result.layout = stream.layout();
  if (auto note = bandsNotShown(result.layout.rate); !note.empty()) result.layout.notes.push_back(std::move(note));
  result.faults = stream.faults();
  if (!result.cancelled) requireShare(result, read, options.leastShare);
  result.notes.insert(result.notes.begin(), result.layout.notes.begin(), result.layout.notes.end());
  return result;
}

bool judgeCandidates(RecordDetection& detection, const Judge& judge, const DetectOptions& options, Monitor& monitor) {
  ThreadTeam team(threadCount(options.threads));
  return std::all_of(detection.channels.begin(), detection.channels.end(), [&](ChannelDetection& channel) {
    return judgeChannel(channel, judge, options, detection.layout.falling, team, monitor);
  });
}

std::vector<bool> attachLabels(RecordDetection& detection, const std::vector<Label>& labels, double shift) {
  auto nearest = nearestTo(labels, detection, 0);
  if (shift != 0) {
    auto shifted = nearestTo(labels, detection, shift);
    const auto missed = [](const std::vector<Event*>& events) {
      return std::count(events.begin(), events.end(), nullptr);
    };
    if (missed(shifted) < missed(nearest)) nearest = std::move(shifted);
  }
  std::vector<bool> isAttached;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (nearest[i]) nearest[i]->label = labels[i];
    isAttached.push_back(nearest[i] != nullptr);
  }
  return isAttached;
}

std::vector<Example> labelledExamples(const RecordDetection& detection, double weight) {
  std::vector<Example> examples;
  for (const auto& channel : detection.channels)
    for (const auto& event : channel.events) {
      if (!event.label) continue;
      const auto& features = event.features;
      const auto& label = *event.label;
      Example example{label.kind, "labels",        label.length,   label.depth, features.speed, 0, weight,
                      {},         features.before, features.reach, {}};
      for (std::size_t b = 0; b < bandCount; ++b)
        example.energy[b] = std::max(0.0, features.energy[b] - features.noise[b]);
      examples.push_back(std::move(example));
    }
  return examples;
}

}  // namespace squat::detection
