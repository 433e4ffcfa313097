#include "project/Report.h"

#include <algorithm>
#include <filesystem>

#include "core/Errors.h"
#include "project/LinkedRun.h"

namespace squat::project {
namespace {

// As the studio has it where none was chosen.
int usualReference(const Report& report) {
  const auto measured =
      std::find_if(report.signals.begin(), report.signals.end(), [](const auto& each) { return !each.result; });
  if (measured != report.signals.end()) return static_cast<int>(measured - report.signals.begin());
  return report.signals.empty() ? -1 : 0;
}

ReportSignal openedRun(const Entry& entry, bool shown, std::string& problem) {
  const auto content = shown ? results::ResultContent::everything : results::ResultContent::withoutFields;
  auto linked = openRun(entry, content);
  problem = linked.problem;
  return {entry.name, entry.path, linked.result, linked.result, {}, entry.overlaid, entry.colour};
}

ReportSignal openedSignal(const Entry& entry, std::string& problem) {
  auto linked = openSignal(entry);
  problem = linked.problem;
  const auto& [record, reading] = linked.measured;
  return {nameWithGain(entry.name, reading), entry.path, record, nullptr, reading, entry.overlaid, entry.colour};
}

}  // namespace

Report reportOf(const Project& project, std::vector<std::string>& problems) {
  Report report;
  report.notes = project.notes;
  for (std::size_t i = 0; i < project.entries.size(); ++i) {
    const Entry& entry = project.entries[i];
    const bool shown = static_cast<int>(i) == project.current;
    std::string problem;
    auto signal = entry.kind == Kind::run ? openedRun(entry, shown, problem) : openedSignal(entry, problem);
    if (!problem.empty()) problems.push_back(problem);
    if (!signal.record) continue;
    if (shown && signal.result) report.shown = static_cast<int>(report.signals.size());
    if (static_cast<int>(i) == project.reference) report.reference = static_cast<int>(report.signals.size());
    report.signals.push_back(std::move(signal));
  }
  if (report.reference < 0) report.reference = usualReference(report);
  addEvents(project.records, report, problems);
  return report;
}

void addEvents(const LongRecords& records, Report& report, std::vector<std::string>& problems) {
  if (records.events.empty()) return;
  try {
    report.events = readEventList(records.events);
  } catch (const FileError& error) {
    problems.emplace_back(error.what());
    return;
  }
  report.eventFolder = std::filesystem::path(records.events).parent_path().string();
  report.seen = records.seen;
}

}  // namespace squat::project
