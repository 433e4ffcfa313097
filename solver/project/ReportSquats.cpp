// The squats and other events of a report.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "project/ReportParts.h"
#include "text/Numbers.h"

namespace squat::project {
namespace {

using text::fixedText;

bool isSquat(const ListedEvent& event) { return event.kind == "squat"; }
bool isNoSquat(const ListedEvent& event) { return !isSquat(event); }

std::string percent(double share) { return fixedText(100 * share, 0) + " %"; }

// In millimetres, with the range that holds nine of ten squats with such a signal.
std::string sizeText(double value, double low, double high, int decimals) {
  const auto millimetres = [&](double metres) { return fixedText(1e3 * metres, decimals); };
  return millimetres(value) + " mm (" + millimetres(low) + " to " + millimetres(high) + " mm)";
}
std::string lengthText(const ListedEvent& event) {
  return sizeText(event.length, event.lengthLow, event.lengthHigh, 0);
}
std::string depthText(const ListedEvent& event) { return sizeText(event.depth, event.depthLow, event.depthHigh, 2); }

// Of a wavy stretch; empty of what is in one place.
std::string stretchText(const ListedEvent& event) {
  return event.extent > 0 ? fixedText(event.extent, 1) : std::string();
}

// "right, 70 % sure"; empty where nobody knows.
std::string railText(const ListedEvent& event) {
  return event.side.empty() ? std::string() : event.side + ", " + percent(event.sideSureness) + " sure";
}

std::string severityText(const ListedEvent& event) {
  const auto& shares = event.severities;
  if (shares[0] + shares[1] + shares[2] == 0) return event.severity;
  return event.severity + " (light " + percent(shares[0]) + ", moderate " + percent(shares[1]) + ", severe " +
         percent(shares[2]) + ")";
}

// What the user has seen at each event, as the studio finds the event again: the nearest one of the channel.
std::vector<std::string> seenAtEvents(const Report& report) {
  constexpr double reach = 0.5;  // [m]
  const auto& events = report.events.events;
  std::vector<std::string> all(events.size());
  for (const auto& seen : report.seen) {
    std::size_t nearest = events.size();
    double distance = reach;
    for (std::size_t i = 0; i < events.size(); ++i) {
      const double away = std::abs(events[i].position - seen.position);
      // What both boxes of a wheelset show is one row, on either channel.
      const bool isHere = events[i].channel == seen.channel || (!events[i].side.empty() && nearest == events.size());
      if (events[i].extent == 0 && isHere && away < distance) nearest = i, distance = away;
    }
    if (nearest < events.size()) all[nearest] = seen.seenAs;
  }
  return all;
}

// Rows whose last columns have a value in at least one of them keep these columns.
void dropEmptyColumns(ReportTable& table) {
  for (std::size_t column = table.columns.size(); column-- > 0;) {
    if (std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) { return !row[column].empty(); }))
      continue;
    table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(column));
    for (auto& row : table.rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  }
}

ReportTable factsOf(const ListedEvent& event, const std::string& seenAs) {
  ReportTable table;
  const auto add = [&](const char* what, const std::string& value) {
    if (!value.empty()) table.rows.push_back({what, value});
  };
  add("Kind", event.kind + ", " + percent(event.sureness) + " sure");
  add("Place", fixedText(event.position, 2) + " m");
  add("Rail", railText(event));
  add("Severity", severityText(event));
  add("Length, with its 90 % range", lengthText(event));
  add("Depth, with its 90 % range", depthText(event));
  add("Largest acceleration", text::roundedText(event.peak) + " m/s²");
  add("Speed", text::roundedText(event.speed) + " m/s");
  if (event.passesThere > 1)
    add("Passages", "found in " + std::to_string(event.passes) + " of " + std::to_string(event.passesThere));
  add("Decided by", event.reason);
  add("Label", seenAs);
  add("Record", std::filesystem::path(event.record).filename().string() + ", channel " + event.channel);
  return table;
}

struct EventColumn {
  const char* heading;
  std::string (*text)(const ListedEvent&);
};
constexpr EventColumn sureColumn{"sure", [](const ListedEvent& event) { return percent(event.sureness); }};
constexpr EventColumn peakColumn{"largest acceleration [m/s²]",
                                 [](const ListedEvent& event) { return text::roundedText(event.peak); }};

// A row for each event of a kind: place and rail, what the columns say, and the user's label. Columns in which nothing
// stands are left out.
ReportTable tableOf(const Report& report, const char* heading, bool (*isListed)(const ListedEvent&),
                    const std::vector<EventColumn>& columns) {
  ReportTable table{heading, {"place [m]", "rail"}, {}};
  for (const auto& column : columns) table.columns.emplace_back(column.heading);
  table.columns.emplace_back("label");
  const auto seen = seenAtEvents(report);
  for (std::size_t i = 0; i < report.events.events.size(); ++i) {
    const auto& event = report.events.events[i];
    if (!isListed(event)) continue;
    auto& row = table.rows.emplace_back(std::vector<std::string>{fixedText(event.position, 2), event.side});
    for (const auto& column : columns) row.push_back(column.text(event));
    row.push_back(seen[i]);
  }
  dropEmptyColumns(table);
  return table;
}

// Places of squats in the list; of too many for a page each, those with the largest accelerations.
std::vector<std::size_t> squatsToShow(const std::vector<ListedEvent>& events) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < events.size(); ++i)
    if (isSquat(events[i])) places.push_back(i);
  if (places.size() <= squatsWithPages) return places;
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return events[a].peak > events[b].peak; });
  places.resize(squatsWithPages);
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

ReportTable squatList(const Report& report) {
  auto table = tableOf(report, "Squats", isSquat,
                       {{"severity", [](const auto& event) { return event.severity; }},
                        sureColumn,
                        {"length (90 % range)", lengthText},
                        {"depth (90 % range)", depthText},
                        peakColumn});
  if (table.rows.size() > squatsWithPages)
    table.heading += " (the " + std::to_string(squatsWithPages) + " loudest have a page each)";
  return table;
}

std::vector<ReportSquat> squatPages(const Report& report) {
  const auto seen = seenAtEvents(report);
  std::vector<ReportSquat> pages;
  for (const std::size_t i : squatsToShow(report.events.events)) {
    const auto& event = report.events.events[i];
    pages.push_back({i, "Squat at " + fixedText(event.position, 2) + " m", factsOf(event, seen[i])});
  }
  return pages;
}

ReportTable otherEvents(const Report& report) {
  return tableOf(report, "Other events", isNoSquat,
                 {{"kind", [](const auto& event) { return event.kind; }},
                  sureColumn,
                  {"length of the stretch [m]", stretchText},
                  peakColumn,
                  {"decided by", [](const auto& event) { return event.reason; }}});
}

}  // namespace squat::project
