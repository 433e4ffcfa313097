#include "commands/DetectionSummary.h"

#include <algorithm>
#include <cstdio>

#include "commands/TextTable.h"

namespace squat::commands {

void printFaults(const detection::RecordDetection& record) {
  constexpr std::size_t shown = 20;
  for (std::size_t i = 0; i < std::min(shown, record.faults.size()); ++i) {
    const auto& fault = record.faults[i];
    std::fprintf(stderr, "%s, %.3f s, %.1f m: %s. %s\n", record.layout.path.c_str(), fault.time, fault.position,
                 fault.text.c_str(), fault.advice.c_str());
  }
  if (record.faults.size() > shown)
    std::fprintf(stderr, "and %zu more faults: squats.json\n", record.faults.size() - shown);
  for (const auto& note : record.notes)
    std::fprintf(stderr, "note: %s: %s\n", record.layout.path.c_str(), note.c_str());
}

void printEvents(const detection::DetectionReport& report) {
  TextTable table(
      {"position [m]", "channel", "kind", "sure", "severity", "length [mm]", "depth [mm]", "peak [m/s²]", "passes"});
  const auto range = [](double value, double low, double high, double factor, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f (%.*f-%.*f)", digits, factor * value, digits, factor * low, digits,
                  factor * high);
    return std::string(text);
  };
  for (const auto& [event, records, scatter] : report.events) {
    const bool isSquat = event.kind == detection::Kind::squat;
    const auto& judged = event.judgement;
    char place[32], sure[16];
    std::snprintf(place, sizeof place, "%.2f", event.position);
    std::snprintf(sure, sizeof sure, "%.0f %%", 100 * event.sureness);
    table.add({place, event.channel, detection::toText(event.kind), sure,
               isSquat ? detection::toText(judged.severity) : event.reason,
               isSquat ? range(judged.length, judged.lengthLow, judged.lengthHigh, 1e3, 0) : "",
               isSquat ? range(judged.depth, judged.depthLow, judged.depthHigh, 1e3, 2) : "", number(event.peak),
               std::to_string(event.passes) + " of " + std::to_string(event.passesThere)});
  }
  for (const auto& record : report.records)
    std::printf("%s: %.1f m in %.1f s, %zu channel%s at %.0f Hz\n", record.layout.path.c_str(), record.length,
                record.duration, record.channels.size(), record.channels.size() == 1 ? "" : "s", record.layout.rate);
  std::printf("kinds and severities from: %s\n\n", report.examples.c_str());
  if (report.events.empty())
    std::printf("nothing that stands out of its surroundings\n");
  else
    std::printf("%s", table.text().c_str());
}

}  // namespace squat::commands
