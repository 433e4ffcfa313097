#include <algorithm>
#include <cmath>
#include <vector>

#include "rcmdx/SpecifiedColumns.h"

namespace squat::rcmdx {
namespace {

constexpr int poorest = 15;  // quality of a position

// An offset that is not known goes with the id -1, which says so.
double orZero(double value) { return std::isfinite(value) ? value : 0; }

std::string directionWord(int direction) { return direction < 0 ? "BACKWARD" : "FORWARD"; }

struct TrackRun {
  std::int32_t id = -1;
  std::int64_t start = 0, end = 0;
  const Place *first = nullptr, *last = nullptr;
};

struct Section {
  int direction = 1;
  std::vector<TrackRun> tracks;
};

// A new section where the vehicle turns; within it a new run where the track changes.
std::vector<Section> sectionsOf(const WayOfSession& way) {
  std::vector<Section> sections;
  for (const auto& [time, place] : way) {
    const int direction = place.direction != 0 ? place.direction : sections.empty() ? 1 : sections.back().direction;
    if (sections.empty() || sections.back().direction != direction) sections.push_back({direction, {}});
    auto& tracks = sections.back().tracks;
    if (!tracks.empty()) tracks.back().end = time;
    if (tracks.empty() || tracks.back().id != place.track) tracks.push_back({place.track, time, time, &place, &place});
    tracks.back().last = &place;
  }
  return sections;
}

double lengthOf(std::int32_t track, const EventsToWrite& events) {
  for (const auto& one : events.tracks)
    if (one.id == track) return one.length;
  return 0;
}

}  // namespace

void writeColumn(TypedFile& file, const std::string& group, const std::string& prefix, const std::string& name,
                 const Cells& values) {
  file.dataset(group + "/" + name, values);
  file.link(group + "/" + name, group + "/" + prefix + "." + name);
}

void writeElement(TypedFile& file, const std::string& group, const std::string& element) {
  file.group(group);
  file.attribute(group, "Element", element);
}

void writePositions(TypedFile& file, const std::string& session, const WayOfSession& way) {
  std::vector<std::uint64_t> times;
  std::vector<double> covered, trackOffset, lineOffset;
  std::vector<std::string> direction, kilometrage;
  std::vector<std::int32_t> track, line, quality;
  std::vector<float> accuracy;
  for (const auto& [time, place] : way) {
    times.push_back(static_cast<std::uint64_t>(time));
    covered.push_back(orZero(place.covered));
    direction.push_back(directionWord(place.direction));
    kilometrage.push_back(place.kilometrage < 0 ? "DECREASING" : "INCREASING");
    track.push_back(place.track);
    line.push_back(place.line);
    trackOffset.push_back(orZero(place.trackOffset));
    lineOffset.push_back(1e-3 * orZero(place.lineOffset));  // [km]
    accuracy.push_back(static_cast<float>(place.accuracy));
    quality.push_back(place.quality >= 0 ? place.quality : poorest);
  }
  // Like a measuring system, but its channel has no attributes: the format itself says what they would.
  const std::string system = session + "/POSITION", source = system + "/POSITION.SOURCE";
  const std::string data = source + "/POSITION.SOURCE.DATA";
  writeElement(file, system, "System");
  file.group(system + "/CONFIGURATION");
  writeElement(file, source, "Datasource");
  file.dataset(source + "/timestamp", times);
  file.group(data);
  const auto column = [&](const char* name, const Cells& cells) { writeColumn(file, data, "data", name, cells); };
  column("covereddistance", covered);
  column("direction", direction);
  column("kilometrage", kilometrage);
  column("track_id", track);
  column("line_id", line);
  column("trackoffset", trackOffset);
  column("lineoffset", lineOffset);
  column("positionaccuracy", accuracy);
  column("positionquality", quality);
}

void writeSections(TypedFile& file, const std::string& session, const WayOfSession& way, std::int64_t start,
                   const EventsToWrite& events) {
  std::vector<std::string> direction, kilometrage;
  std::vector<std::uint64_t> from, to, trackFrom, trackTo;
  std::vector<double> firstOffset, lastOffset, infoOffset, coveredFrom, coveredTo;
  std::vector<std::int32_t> track;
  for (const auto& section : sectionsOf(way)) {
    const auto &first = section.tracks.front(), &last = section.tracks.back();
    direction.push_back(directionWord(section.direction));
    from.push_back(static_cast<std::uint64_t>(first.start));
    to.push_back(static_cast<std::uint64_t>(std::max(last.end, first.start + 1)));  // must be later than the start
    firstOffset.push_back(orZero(first.first->trackOffset));
    lastOffset.push_back(std::max(0.0, lengthOf(last.id, events) - orZero(last.last->trackOffset)));
    for (const auto& run : section.tracks) {
      track.push_back(run.id);
      // Since the beginning of the session, as the specification describes them.
      trackFrom.push_back(static_cast<std::uint64_t>(run.start - start));
      trackTo.push_back(static_cast<std::uint64_t>(std::max(run.end, run.start + 1) - start));
      kilometrage.push_back(run.first->kilometrage < 0 ? "DESCENDING" : "ASCENDING");
      coveredFrom.push_back(orZero(run.first->covered));
      coveredTo.push_back(orZero(run.last->covered));
    }
    infoOffset.push_back(static_cast<double>(track.size()));  // tracks of this section and of those before
  }
  const std::string group = session + "/SECTIONS";
  writeElement(file, group, "Sections");
  const auto column = [&](const char* name, const Cells& cells) { writeColumn(file, group, "section", name, cells); };
  column("direction", direction);
  column("startTimestamp", from);
  column("endTimestamp", to);
  column("firstTrackOffset", firstOffset);
  column("lastTrackOffset", lastOffset);
  column("trackInfoOffset", infoOffset);
  column("trackId", track);
  column("trackStartTimestamp", trackFrom);
  column("trackEndTimestamp", trackTo);
  column("trackKilometrage", kilometrage);
  column("trackStartCoveredDistance", coveredFrom);
  column("trackEndCoveredDistance", coveredTo);
}

}  // namespace squat::rcmdx
