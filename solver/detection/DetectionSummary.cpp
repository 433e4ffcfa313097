#include "detection/DetectionSummary.h"

#include <algorithm>
#include <cstdio>

#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::detection {

using text::formatted;

namespace {

std::string rangeText(double value, double low, double high, double factor, const char* format) {
  return formatted(format, factor * value) + " (" + formatted(format, factor * low) + "-" +
         formatted(format, factor * high) + ")";
}

std::string sideText(const Event& event) {
  return event.side ? toText(event.side->side()) + formatted(" %.0f %%", 100 * event.side->sureness()) : "";
}

std::vector<std::string> summaryCells(const Event& event, bool withSides) {
  const bool isSquat = event.kind == Kind::squat;
  const auto& judged = event.judgement;
  std::vector cells{formatted("%.2f", event.position), event.channel};
  if (withSides) cells.push_back(sideText(event));
  cells.insert(
      cells.end(),
      {toText(event.kind), formatted("%.0f %%", 100 * event.sureness), isSquat ? toText(judged.severity) : event.reason,
       isSquat ? rangeText(judged.length, judged.lengthLow, judged.lengthHigh, 1e3, "%.0f") : "",
       isSquat ? rangeText(judged.depth, judged.depthLow, judged.depthHigh, 1e3, "%.2f") : "",
       text::roundedText(event.peak), std::to_string(event.passes) + " of " + std::to_string(event.passesThere)});
  return cells;
}

}  // namespace

std::string faultText(const RecordDetection& record) {
  constexpr std::size_t shown = 20;
  const auto& path = record.layout.path;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, record.faults.size()); ++i) {
    const auto& fault = record.faults[i];
    text += path + ", " + formatted("%.3f s", fault.time) + ", " + formatted("%.1f m", fault.position) + ": " +
            fault.text + ". " + fault.advice + "\n";
  }
  if (record.faults.size() > shown)
    text += "and " + std::to_string(record.faults.size() - shown) + " more faults: squats.json\n";
  for (const auto& note : record.notes) text += "note: " + path + ": " + note + "\n";
  return text;
}

std::string detectionSummary(const DetectionReport& report) {
  std::string text;
  for (const auto& record : report.records) {
    const auto channels = record.channels.size();
    text += record.layout.path + ": " + formatted("%.1f m", record.length) + " in " +
            formatted("%.1f s", record.duration) + ", " + std::to_string(channels) +
            (channels == 1 ? " channel at " : " channels at ") + formatted("%.0f Hz", record.layout.rate) + "\n";
  }
  text += "kinds and severities from: " + report.examples + "\n";
  for (const auto& note : report.notes) text += note + "\n";
  text += "\n";
  if (report.events.empty()) return text + "nothing that stands out of its surroundings\n";
  const bool withSides = std::any_of(report.events.begin(), report.events.end(),
                                     [](const CombinedEvent& combined) { return combined.event.side.has_value(); });
  std::vector<std::string> heads{"position [m]", "channel"};
  if (withSides) heads.emplace_back("side");
  heads.insert(heads.end(), {"kind", "sure", "severity", "length [mm]", "depth [mm]", "peak [m/s²]", "passes"});
  text::TextTable table(heads);
  for (const auto& combined : report.events) table.add(summaryCells(combined.event, withSides));
  return text + table.text();
}

}  // namespace squat::detection
