#include "detection/Stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/Numbers.h"

namespace squat::detection {
namespace {

using text::formatted;

// Both values are assumed: one measured track with corrugation and one without are too few to count errors.
constexpr double surenessVaried = 0.7, surenessSteady = 0.5;

std::string stretchReason(const Event& stretch) {
  return formatted("%.0f m of waves", stretch.extent) + formatted(" of %.0f mm", 1e3 * stretch.features.wavelength);
}

bool areOne(const Event& one, const Event& other) {
  constexpr double likeWavelength = 1.15;
  if (one.channel != other.channel) return false;
  const double ratio = one.features.wavelength / other.features.wavelength;
  if (std::max(ratio, 1 / ratio) > likeWavelength) return false;
  const double common =
      std::min(one.position + one.extent, other.position + other.extent) - std::max(one.position, other.position);
  return common >= 0.5 * std::min(one.extent, other.extent);
}

void extendBy(CombinedEvent& stretch, const Event& other, std::size_t record) {
  auto& event = stretch.event;
  const double end = std::max(event.position + event.extent, other.position + other.extent);
  event.position = std::min(event.position, other.position), event.extent = end - event.position;
  event.peak = std::max(event.peak, other.peak);
  const double one = event.features.speed, two = other.features.speed;
  event.sureness = std::max(event.sureness, other.sureness);
  if (areVaried(std::min(one, two), std::max(one, two))) event.sureness = std::max(event.sureness, surenessVaried);
  event.judgement.sureness = event.sureness;
  event.reason = stretchReason(event);
  if (stretch.records.back() != record) stretch.records.push_back(record);
}

}  // namespace

bool areVaried(double slowest, double fastest) { return fastest > 1.2 * slowest; }

std::vector<Event> stretchEvents(const ChannelDetection& channel, const std::string& unit) {
  std::vector<Event> events;
  for (const auto& stretch : channel.waves) {
    Event event;
    event.channel = channel.name, event.unit = unit;
    event.time = stretch.time;
    event.position = std::min(stretch.from, stretch.to), event.extent = std::abs(stretch.to - stretch.from);
    event.latitude = event.longitude = std::numeric_limits<double>::quiet_NaN();
    event.kind = event.judgement.kind = Kind::corrugation;
    event.features.speed = 0.5 * (stretch.slowest + stretch.fastest);
    event.features.wavelength = stretch.wavelength;
    for (const auto& piece : channel.pieces)
      if (piece.position >= event.position && piece.position < event.position + event.extent)
        event.peak = std::max(event.peak, piece.peak);
    event.sureness = event.judgement.sureness =
        areVaried(stretch.slowest, stretch.fastest) ? surenessVaried : surenessSteady;
    event.reason = stretchReason(event);
    events.push_back(std::move(event));
  }
  return events;
}

std::vector<CombinedEvent> combinedStretches(const std::vector<RecordDetection>& detections,
                                             const std::vector<double>& shifts) {
  std::vector<CombinedEvent> stretches;
  for (std::size_t r = 0; r < detections.size(); ++r) {
    const auto& units = detections[r].layout.channels;
    for (std::size_t c = 0; c < detections[r].channels.size(); ++c)
      for (auto& event : stretchEvents(detections[r].channels[c], c < units.size() ? units[c].unit : std::string())) {
        event.position += shifts[r];
        const auto same = std::find_if(stretches.begin(), stretches.end(), [&](const CombinedEvent& each) {
          return each.records.front() != r && areOne(each.event, event);
        });
        if (same == stretches.end())
          stretches.push_back({std::move(event), {r}, 0});
        else
          extendBy(*same, event, r);
      }
  }
  for (auto& stretch : stretches) {
    auto& event = stretch.event;
    event.passes = stretch.records.size();
    event.passesThere = std::max(passesAt(detections, shifts, event.position + 0.5 * event.extent), event.passes);
  }
  return stretches;
}

}  // namespace squat::detection
