#include "detection/DetectionFiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Cells.h"
#include "text/Csv.h"
#include "text/Heading.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::detection {
namespace {

using Json = nlohmann::ordered_json;

// To the digits that mean something.
double rounded(double value, double unit) { return std::round(value / unit) * unit; }

double powerOf(const Event& event, std::size_t band) {
  const auto window = eventWindow(band);
  const double seconds = (window.before + window.behind) / std::max(event.features.speed, minimumSpeed);
  return std::max(0.0, event.features.energy[band] - event.features.noise[band]) / seconds;
}

// To two digits, and 0 below one in a billion kilometres.
double withTwoDigits(double alarms) {
  if (alarms < 1e-9) return 0;
  return std::stod(text::formatted("%.2g", alarms));
}

// [m] of a stretch; else of the neighbourhood that is at least a tenth as loud.
double extentOf(const Event& event) { return event.extent > 0 ? event.extent : event.features.reach; }

// The largest value of the other axle box by that of this one.
double otherSidePercent(const Event& event) { return event.peak > 0 ? 100 * event.otherPeak / event.peak : 0; }

bool isSquat(const Event& event) { return event.kind == Kind::squat; }

std::string head() {
  std::string text = "position [m],time [s],record,channel,kind,sureness,severity,score,peak [m/s2],speed [m/s]";
  for (const auto& band : detectionBands()) text += ",power " + band.name + " [(m/s2)2]";
  return text +
         ",wavelength [mm],length [mm],length low [mm],length high [mm],depth [mm],depth low [mm],"
         "depth high [mm],passes,passes there,latitude [deg],longitude [deg],false alarms [1/km],extent "
         "[m],light,moderate,"
         "severe,side,side sureness,other side [%],reason,passage\n";
}

// Of an event, by its row in the table. Empty for what is no squat.
std::string passageFile(const DetectionReport& report, std::size_t event) {
  return isSquat(report.events[event].event) ? passageName(report.events[event], event) : std::string();
}

bool isPassageFile(const std::string& name) {
  const std::string head = "squat-", end = ".csv";
  if (!name.starts_with(head) || !name.ends_with(end) || name.size() < head.size() + 4 + end.size()) return false;
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(head.size()),
                     name.end() - static_cast<std::ptrdiff_t>(end.size()), [](char c) { return c >= '0' && c <= '9'; });
}

// Returns their number. Those of an earlier call are removed: whoever takes all files of the folder gets this list's.
std::size_t writePassages(const DetectionReport& report, const std::string& folder) {
  std::set<std::string> written;
  for (std::size_t i = 0; i < report.events.size(); ++i) {
    const auto file = passageFile(report, i);
    if (file.empty()) continue;
    if (written.empty()) makeFolder(folder + "/passages");
    writeDurably(folder + "/" + file, passageCsv(report.events[i].event));
    written.insert(std::filesystem::path(file).filename().string());
  }
  std::error_code none;
  std::vector<std::filesystem::path> earlier;
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/passages", none))
    if (const auto name = entry.path().filename().string(); isPassageFile(name) && written.count(name) == 0)
      earlier.push_back(entry.path());
  for (const auto& path : earlier) std::filesystem::remove(path, none);
  return written.size();
}

std::string row(const DetectionReport& report, std::size_t index) {
  const auto& combined = report.events[index];
  const auto& event = combined.event;
  const auto& judged = event.judgement;
  std::vector<std::string> cells{text::fixedText(event.position, 3),
                                 text::fixedText(event.time, 5),
                                 report.records[combined.records.front()].layout.path,
                                 event.channel,
                                 toText(event.kind),
                                 text::fixedText(event.sureness, 2),
                                 isSquat(event) ? toText(judged.severity) : "",
                                 text::fixedText(event.score, 1),
                                 text::fixedText(event.peak, 1),
                                 text::fixedText(event.features.speed, 2)};
  for (std::size_t b = 0; b < bandCount; ++b) cells.push_back(text::fixedText(powerOf(event, b), 2));
  cells.push_back(event.features.wavelength > 0 ? text::fixedText(1e3 * event.features.wavelength, 1) : "");
  for (const double length : {judged.length, judged.lengthLow, judged.lengthHigh})
    cells.push_back(isSquat(event) ? text::fixedText(1e3 * length, 0) : "");
  for (const double depth : {judged.depth, judged.depthLow, judged.depthHigh})
    cells.push_back(isSquat(event) ? text::fixedText(1e3 * depth, 3) : "");
  cells.push_back(std::to_string(event.passes));
  cells.push_back(std::to_string(event.passesThere));
  cells.push_back(text::fixedText(event.latitude, 7));
  cells.push_back(text::fixedText(event.longitude, 7));
  cells.push_back(event.extent > 0 ? "" : text::numberText(withTwoDigits(event.falseAlarms)));
  cells.push_back(text::fixedText(extentOf(event), 2));
  for (const double severity : judged.severities) cells.push_back(isSquat(event) ? text::fixedText(severity, 2) : "");
  cells.push_back(event.side ? toText(event.side->side()) : "");
  cells.push_back(event.side ? text::fixedText(event.side->sureness(), 2) : "");
  cells.push_back(event.side ? text::fixedText(otherSidePercent(event), 0) : "");
  cells.push_back(event.reason);
  cells.push_back(passageFile(report, index));
  std::string text;
  for (const auto& cell : cells) text += (text.empty() ? "" : ",") + text::csvField(cell);
  return text + '\n';
}

Json jsonOf(const DetectionReport& report, const CombinedEvent& combined) {
  const auto& event = combined.event;
  const auto& judged = event.judgement;
  Json powers;
  for (std::size_t b = 0; b < bandCount; ++b) powers[detectionBands()[b].name] = rounded(powerOf(event, b), 1e-2);
  Json json{{"position_m", rounded(event.position, 1e-3)},
            {"time_s", rounded(event.time, 1e-5)},
            {"record", report.records[combined.records.front()].layout.path},
            {"channel", event.channel},
            {"kind", toText(event.kind)},
            {"sureness", rounded(event.sureness, 1e-2)},
            {"score", rounded(event.score, 0.1)},
            {"peak_m_s2", rounded(event.peak, 0.1)},
            {"speed_m_s", rounded(event.features.speed, 1e-2)},
            {"power_m2_s4", powers},
            {"wavelength_mm", rounded(1e3 * event.features.wavelength, 0.1)},
            {"passes", event.passes},
            {"passes_there", event.passesThere}};
  if (isSquat(event)) {
    json["severity"] = toText(judged.severity);
    json["severity_sureness"] = rounded(judged.severitySureness, 1e-2);
    for (std::size_t s = 0; s < judged.severities.size(); ++s)
      json["severities"][toText(static_cast<Severity>(s))] = rounded(judged.severities[s], 1e-2);
    json["length_mm"] = {rounded(1e3 * judged.length, 1), rounded(1e3 * judged.lengthLow, 1),
                         rounded(1e3 * judged.lengthHigh, 1)};
    json["depth_mm"] = {rounded(1e3 * judged.depth, 1e-3), rounded(1e3 * judged.depthLow, 1e-3),
                        rounded(1e3 * judged.depthHigh, 1e-3)};
    json["impact_mm"] = rounded(1e3 * judged.offset, 1);
  }
  if (std::isfinite(event.latitude)) json["latitude_deg"] = event.latitude, json["longitude_deg"] = event.longitude;
  json["extent_m"] = rounded(extentOf(event), 0.01);
  if (event.extent == 0) json["false_alarms_per_km"] = withTwoDigits(event.falseAlarms);
  if (event.side) {
    json["side"] = toText(event.side->side());
    json["side_sureness"] = rounded(event.side->sureness(), 1e-2);
    json["other_side_percent"] = rounded(otherSidePercent(event), 1);
  }
  if (!event.reason.empty()) json["reason"] = event.reason;
  return json;
}

Json jsonOf(const RecordDetection& record) {
  Json faults = Json::array(), channels = Json::array();
  for (const auto& fault : record.faults)
    faults.push_back(
        {{"position_m", fault.position}, {"time_s", fault.time}, {"text", fault.text}, {"advice", fault.advice}});
  for (const auto& channel : record.channels) {
    Json one{{"name", channel.name}};
    if (channel.circumference > 0) one["flats_repeat_m"] = rounded(channel.circumference, 1e-3);
    channels.push_back(one);
  }
  return {{"path", record.layout.path},    {"rate_hz", record.layout.rate}, {"length_m", rounded(record.length, 0.1)},
          {"duration_s", record.duration}, {"channels", channels},          {"faults", faults},
          {"notes", record.notes}};
}

Json jsonOf(const SeverityLimits& limits) {
  const auto inMillimetres = [](double length, double depth) {
    return Json{rounded(1e3 * length, 1e-3), rounded(1e3 * depth, 1e-3)};
  };
  return {{"light", inMillimetres(limits.lightLength, limits.lightDepth)},
          {"moderate", inMillimetres(limits.moderateLength, limits.moderateDepth)}};
}

// Names of files and channels need not be UTF-8.
std::string textOf(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

std::size_t columnOf(const std::vector<std::string>& names, std::string_view wanted) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (text::lowerCase(text::bracketedHeading(names[i]).name) == wanted) return i;
  return names.size();
}

// Metres in one of the heading's unit.
double metresOf(const std::string& name, double usual, const std::string& path) {
  const auto stated = text::bracketedHeading(name).unit;
  if (stated.empty()) return usual;
  const auto* unit = text::findUnit(stated);
  if (unit == nullptr || unit->si != "m")
    throw FileError(path, "line 1", "'" + name + "' is in " + stated + ", which is no length",
                    "Give metres, km, mm or um");
  return unit->factor;
}

}  // namespace

std::string passageName(const CombinedEvent& event, std::size_t index) {
  char name[64];
  std::snprintf(name, sizeof name, "%s/%s-%04zu.csv", isSquat(event.event) ? "passages" : "other-events",
                toText(event.event.kind).c_str(), index + 1);
  return name;
}

// The strongest passage over the event, in the direction of travel, at its speed.
std::string passageCsv(const Event& event) {
  std::vector<double> time, speed(event.passage.values.size(), event.features.speed);
  for (std::size_t i = 0; i < event.passage.values.size(); ++i) time.push_back(event.passage.timeAt(i));
  return text::csvColumns({"time [s]", "speed [m/s]", "aba [" + event.passage.unit + "]"},
                          {&time, &speed, &event.passage.values});
}

std::string labelsCsv(const std::vector<SeenEvent>& seen) {
  std::string text = "position [m],channel,kind,severity\n";
  for (const auto& one : seen)
    text += text::fixedText(one.position, 3) + "," + text::csvField(one.channel) + "," + toText(one.kind) + "," +
            (one.kind == Kind::squat ? toText(one.severity) : std::string()) + "\n";
  return text;
}

std::string detectionCsv(const DetectionReport& report) {
  std::string text = head();
  for (std::size_t i = 0; i < report.events.size(); ++i) text += row(report, i);
  return text;
}

std::string detectionJson(const DetectionReport& report) {
  Json events = Json::array(), records = Json::array();
  for (const auto& event : report.events) events.push_back(jsonOf(report, event));
  for (const auto& record : report.records) records.push_back(jsonOf(record));
  return textOf({{"schema", "squat-detection"},
                 {"schema_version", 1},
                 {"examples", report.examples},
                 {"severity_limits_mm", jsonOf(report.limits)},
                 {"records", records},
                 {"events", events},
                 {"notes", report.notes}});
}

std::string detectionGeoJson(const DetectionReport& report) {
  Json features = Json::array();
  for (const auto& combined : report.events) {
    const auto& event = combined.event;
    if (!std::isfinite(event.latitude) || !std::isfinite(event.longitude)) continue;
    features.push_back({{"type", "Feature"},
                        {"geometry", {{"type", "Point"}, {"coordinates", {event.longitude, event.latitude}}}},
                        {"properties", jsonOf(report, combined)}});
  }
  if (features.empty()) return {};
  return textOf({{"type", "FeatureCollection"}, {"features", features}});
}

std::vector<std::string> writeDetection(const DetectionReport& report, const std::string& folder) {
  std::vector<std::string> paths;
  const auto write = [&](const char* name, const std::string& text) {
    if (text.empty()) return;
    paths.push_back(folder + "/" + name);
    writeDurably(paths.back(), text);
  };
  write("squats.csv", detectionCsv(report));
  write("squats.json", detectionJson(report));
  write("squats.geojson", detectionGeoJson(report));
  if (writePassages(report, folder) > 0) paths.push_back(folder + "/passages");
  return paths;
}

std::vector<Label> readLabels(const std::string& path) {
  constexpr std::size_t largest = std::size_t{64} << 20;
  const auto table = text::readCells(path, largest);
  const auto& rows = table.rows;
  const auto& lines = table.lines;
  const auto names = rows.empty() ? std::vector<std::string>{} : rows.front();
  const auto position = columnOf(names, "position"), kind = columnOf(names, "kind");
  if (position == names.size() || kind == names.size())
    throw FileError(path, "line 1", "must have the columns 'position [m]' and 'kind'",
                    "Correct the kinds in squats.csv and give that file");
  const bool areEstimates =
      columnOf(names, "length low") < names.size();  // squats.csv: only kind and severity are seen
  std::vector<Label> labels;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto place = "line " + std::to_string(lines[i]);
    const auto cell = [&](const char* column) {
      const auto at = columnOf(names, column);
      return at < std::min(names.size(), rows[i].size()) ? rows[i][at] : std::string();
    };
    // [m], whatever length the heading states; of a heading without a unit, `usual`.
    const auto metres = [&](const char* column, double usual) -> std::optional<double> {
      const auto number = text::numberIn(cell(column), '.');
      if (!number && !cell(column).empty())
        throw FileError(path, place, "'" + cell(column) + "' is no number for '" + column + "'", "Correct the cell");
      if (!number) return std::nullopt;
      return *number * metresOf(names[columnOf(names, column)], usual, path);
    };
    // Stretches of corrugation, in squats.csv, are no events.
    if (columnOf(names, "false alarms") < names.size() && cell("false alarms").empty()) continue;
    const auto where = metres("position", 1);
    if (!where) throw FileError(path, place, "'" + cell("position") + "' is not a position");
    Label label;
    label.position = *where;
    label.channel = cell("channel");
    if (!areEstimates)
      label.length = metres("length", 1e-3).value_or(0), label.depth = metres("depth", 1e-3).value_or(0);
    try {
      label.kind = kindFromText(cell("kind"));
      if (const auto severity = cell("severity"); label.kind == Kind::squat && !severity.empty())
        label.severity = severityFromText(severity);
    } catch (const CaseError& error) {
      throw FileError(path, place, error.what());
    }
    labels.push_back(label);
  }
  return labels;
}

}  // namespace squat::detection
