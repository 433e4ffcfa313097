#include "detection/RcmDxEvents.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <system_error>

#include "core/ProgramVersion.h"
#include "rcmdx/EventsToWrite.h"
#include "rcmdx/RecordColumns.h"
#include "readers/ArrayFile.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

constexpr double kNanoseconds = 1e9;  // in a second

rcmdx::EventToWrite eventOf(const Event& found, std::int64_t start, rcmdx::PlaceFinder& places) {
  rcmdx::EventToWrite event;
  event.time = start + std::llround(kNanoseconds * found.time);
  event.channel = found.channel;
  event.kind = toText(found.kind);
  event.details = found.reason;
  event.peak = found.peak;
  event.latitude = found.latitude, event.longitude = found.longitude;
  event.place = places.at(event.time);
  event.parameters.emplace_back("sureness", text::fixedText(found.sureness, 2));
  if (found.side) {
    event.parameters.emplace_back("side", toText(found.side->side()));
    event.parameters.emplace_back("side sureness", text::fixedText(found.side->sureness(), 2));
  }
  if (found.kind != Kind::squat) return event;
  event.severity = toText(found.judgement.severity);
  event.parameters.insert(event.parameters.begin(), {{"length [mm]", text::fixedText(1e3 * found.judgement.length, 0)},
                                                     {"depth [mm]", text::fixedText(1e3 * found.judgement.depth, 3)}});
  return event;
}

// Names of the tracks and lines that the events lie on.
void addNetwork(rcmdx::EventsToWrite& all, const rcmdx::NetworkNames& names) {
  std::set<std::int32_t> tracks, lines;
  for (const auto& event : all.events) {
    if (event.place.track >= 0) tracks.insert(event.place.track);
    if (event.place.line >= 0) lines.insert(event.place.line);
  }
  const auto nameOf = [](const std::map<std::int32_t, std::string>& known, std::int32_t id) {
    const auto found = known.find(id);
    return found == known.end() ? std::to_string(id) : found->second;
  };
  for (const auto id : tracks) all.tracks.push_back({id, nameOf(names.tracks, id), "", 0});
  for (const auto id : lines) all.lines.push_back({id, nameOf(names.lines, id)});
}

}  // namespace

std::vector<std::string> writeRcmDxEvents(const DetectionReport& report, const readers::SignalFileOptions& reading,
                                          const std::string& folder) {
  const auto path = folder + "/squats.rcmdx";
  std::error_code ignored;
  std::filesystem::remove(path, ignored);  // of an earlier search
  if (report.records.size() != 1) return {};
  const auto& record = report.records.front();
  if (!readers::isArrayFile(record.layout.path) || record.layout.files.size() > 1) return {};
  const auto tree = readers::listArrays(record.layout.path);
  if (!rcmdx::isRcmDx(tree)) return {};
  const auto session = rcmdx::recordColumns(record.layout.path, tree, {reading.object, reading.positionColumn});
  rcmdx::EventsToWrite all;
  all.start = session.start();
  all.end = session.start() + std::llround(kNanoseconds * record.duration);
  all.alias = std::filesystem::path(record.layout.path).stem().string();
  all.program = "squat " + std::string(programVersion());
  for (const auto& channel : record.layout.channels) {
    auto& written = all.channels.emplace_back();
    written.name = channel.name, written.unit = channel.unit;
  }
  rcmdx::PlaceFinder places(session.positions());
  for (const auto& combined : report.events) all.events.push_back(eventOf(combined.event, session.start(), places));
  addNetwork(all, rcmdx::readNames(record.layout.path, tree, session.session()));
  all.kinds = {"squat", "joint", "weld", "corrugation", "flat", "other"};
  all.severities = {"light", "moderate", "severe"};
  rcmdx::writeRcmDx(path, all);
  return {path};
}

}  // namespace squat::detection
