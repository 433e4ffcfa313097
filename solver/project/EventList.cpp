#include "project/EventList.h"

#include <algorithm>

#include "core/DurableFile.h"
#include "project/JsonNode.h"

namespace squat::project {
namespace {

constexpr std::size_t largestEventFile = 64U << 20U;  // [bytes]
constexpr std::size_t maximumEvents = 1000000;
constexpr int newestSchema = 1;
constexpr double largestNumber = 1e12;

ListedEvent eventIn(const JsonNode& node, const std::vector<std::string>& records) {
  ListedEvent event;
  event.position = node.at("position_m").number(-largestNumber, largestNumber);
  event.time = node.at("time_s").number(-largestNumber, largestNumber);
  event.record = node.at("record").text();
  if (std::find(records.begin(), records.end(), event.record) == records.end())
    node.at("record").fail("is none of the records of the list");
  event.channel = node.at("channel").text();
  event.kind = node.at("kind").text();
  if (node.has("reason")) event.reason = node.at("reason").text();
  event.sureness = node.at("sureness").number(0, 1);
  event.peak = node.at("peak_m_s2").number(0, largestNumber);
  event.speed = node.at("speed_m_s").number(0, largestNumber);
  // Events say as well how often the background alone makes them; older lists have neither.
  if (node.has("extent_m") && !node.has("false_alarms_per_km"))
    event.extent = node.at("extent_m").number(0, largestNumber);
  constexpr int maximumPasses = 1000000;
  event.passes = node.at("passes").whole(0, maximumPasses);
  event.passesThere = node.at("passes_there").whole(0, maximumPasses);
  if (node.has("side")) {
    event.side = node.at("side").text();
    event.sideSureness = node.at("side_sureness").number(0, 1);
  }
  if (!node.has("severity")) return event;
  event.severity = node.at("severity").text();
  const auto take = [&](const char* key, double& value, double& low, double& high) {
    const auto values = node.at(key).list();
    if (!values.empty()) value = 1e-3 * values[0].number(0, largestNumber);
    if (values.size() != 3) node.at(key).fail("is not an estimate with its two limits");
    low = 1e-3 * values[1].number(0, largestNumber), high = 1e-3 * values[2].number(0, largestNumber);
  };
  take("length_mm", event.length, event.lengthLow, event.lengthHigh);
  take("depth_mm", event.depth, event.depthLow, event.depthHigh);
  if (node.has("impact_mm"))  // older lists do not say it
    event.impact = 1e-3 * node.at("impact_mm").number(-largestNumber, largestNumber);
  if (!node.has("severities")) return event;
  const JsonNode severities = node.at("severities");
  event.severities = {severities.at("light").number(0, 1), severities.at("moderate").number(0, 1),
                      severities.at("severe").number(0, 1)};
  return event;
}

}  // namespace

EventList parseEventList(const std::string& text, const std::string& origin) {
  const std::string advice = "Start the search again";
  const auto json = parsedJson(text, origin, advice);
  const JsonNode root(json, origin, advice);
  if (root.at("schema").text() != "squat-detection") root.at("schema").fail("is not a list of events");
  const JsonNode version = root.at("schema_version");
  if (version.whole(1, 1 << 30) > newestSchema) version.fail("is newer than this version of the program reads");
  EventList list;
  for (const auto& record : root.at("records").list()) list.records.push_back(record.at("path").text());
  for (const auto& event : root.at("events").list(maximumEvents)) list.events.push_back(eventIn(event, list.records));
  return list;
}

EventList readEventList(const std::string& path) { return parseEventList(readWholeFile(path, largestEventFile), path); }

}  // namespace squat::project
