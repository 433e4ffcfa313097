#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/Interrupt.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "records/Inspection.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::commands {

namespace {

struct InspectOptions {
  std::vector<std::string> files;
  SignalOptions signal;
  bool json = false;
};

std::string columnTable(const records::Inspection& seen) {
  text::TextTable table({"column", "name", "unit", "read as", "first rows"});
  for (std::size_t c = 0; c < seen.columns.size(); ++c) {
    const auto& column = seen.columns[c];
    std::string rows;
    for (const double value : column.first)
      rows += (rows.empty() ? "" : "  ") + (std::isfinite(value) ? text::numberText(value) : std::string("-"));
    table.add({std::to_string(c + 1), column.name, text::printedUnit(column.unit), column.use, rows});
  }
  return table.text(text::kTerminalWidth);
}

std::string recordText(const records::Inspection& seen) {
  if (!seen.layout) return {};
  std::string text = text::roundedText(seen.layout->rate) + " Hz, " + std::to_string(seen.read) + " samples, " +
                     text::formatted("%.3f s", seen.duration);
  if (seen.way)
    text += ", " + text::formatted("%.1f m", *seen.way) + ", " +
            text::formatted("%.1f m/s on the average", seen.duration > 0 ? *seen.way / seen.duration : 0);
  return text + "\n";
}

std::string inspectionText(const records::Inspection& seen) {
  constexpr std::size_t shown = 20;
  std::string text = seen.path + ": " + seen.structure + "\n\n" + columnTable(seen) + "\n" + recordText(seen);
  for (const auto& doubt : seen.doubts) text += "note: " + doubt + "\n";
  for (std::size_t i = 0; i < std::min(shown, seen.faults.size()); ++i)
    text += text::formatted("%.3f s: ", seen.faults[i].time) + seen.faults[i].text + "\n";
  if (seen.faults.size() > shown) text += "and " + std::to_string(seen.faults.size() - shown) + " more\n";
  if (!seen.refusal.empty()) text += "not a record that can be searched: " + seen.refusal + "\n";
  return text;
}

nlohmann::ordered_json inspectionJson(const records::Inspection& seen) {
  using Json = nlohmann::ordered_json;
  Json columns = Json::array(), faults = Json::array();
  for (const auto& column : seen.columns)
    columns.push_back(
        {{"name", column.name}, {"unit", column.unit}, {"read_as", column.use}, {"first_rows", column.first}});
  for (const auto& fault : seen.faults) faults.push_back({{"time_s", fault.time}, {"text", fault.text}});
  Json json{{"path", seen.path}, {"structure", seen.structure}, {"columns", columns}};
  if (seen.layout) {
    json["rate_hz"] = seen.layout->rate, json["samples"] = seen.read, json["duration_s"] = seen.duration;
    if (seen.way) json["way_m"] = *seen.way;
  }
  json["notes"] = seen.doubts, json["faults"] = faults;
  if (!seen.refusal.empty()) json["refusal"] = seen.refusal;
  return json;
}

int inspect(const InspectOptions& options) {
  records::RecordOptions read;
  read.columns = fileOptions(options.signal);
  read.everyAcceleration = true;
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  auto all = nlohmann::ordered_json::array();
  bool areRecords = true;
  for (const auto& file : options.files) {
    const auto seen = records::inspectRecord(recordFile(file), read, monitor);
    monitor.clearLine();
    if (seen.cancelled) return kCancelled;
    areRecords = areRecords && seen.refusal.empty();
    if (options.json)
      all.push_back(inspectionJson(seen));
    else
      std::printf("%s%s", &file == &options.files.front() ? "" : "\n", inspectionText(seen).c_str());
  }
  if (options.json)
    std::printf("%s\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
  return areRecords ? kDone : kFileWrong;
}

}  // namespace

void addInspectCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("inspect", "Show how a measured file is understood: columns, units, rate, gaps");
  auto options = std::make_shared<InspectOptions>();
  command->add_option("files", options->files, "Measured files, or the shipped example-record")
      ->required()
      ->type_name("FILE...");
  addSignalOptions(*command, options->signal);
  command->add_flag("--json", options->json, "Print JSON, for scripts");
  command->callback([options, &action] { action = [options] { return inspect(*options); }; });
}

}  // namespace squat::commands
