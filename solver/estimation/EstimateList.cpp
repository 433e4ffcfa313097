#include "estimation/EstimateList.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "case/CaseDescription.h"
#include "case/ShortHash.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "estimation/EstimateFiles.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::estimation {

namespace {

using Json = nlohmann::json;
constexpr std::size_t kLargestFile = std::size_t{64} << 20;

std::string rowFile(const std::string& folder, const std::string& file) {
  return estimateFolder(folder, file) + "/estimate.json";
}

}  // namespace

std::string estimateFolder(const std::string& folder, const std::string& file) {
  return folder + "/" + std::filesystem::path(file).stem().string();
}

std::string estimateKey(const EstimateDefinition& definition, const EstimateOptions& options) {
  std::string all = cases::caseHash(cases::loadCase(definition.caseName, definition.overrides));
  for (const auto& name : {definition.reading.column, definition.reading.timeColumn, definition.reading.positionColumn,
                           definition.reading.speedColumn, definition.reading.runColumn, definition.reading.object})
    all += "," + name;
  for (const auto& [column, unit] : definition.reading.units) all += "," + column + "=" + unit;
  all += "," + definition.reading.signalUnit + "," + definition.reading.timeUnit;
  for (const double number : {definition.reading.rate, definition.reading.speed, definition.cutoff, definition.longest,
                              definition.beyond, static_cast<double>(options.runs)})
    all += "," + text::numberText(number);
  all += "," + std::to_string(definition.reading.headLine);
  all += std::string(",") + definition.reading.delimiter + definition.reading.decimal;
  for (const auto& file : definition.files) all += "," + cases::shortHash(readWholeFile(file, kLargestFile));
  return cases::shortHash(all);
}

EstimateRow rowOf(const std::string& file, const Estimate& estimate) {
  EstimateRow row{file, false, {}, estimate.depth, estimate.length, estimate.misfit, 0, estimate.runs};
  for (const auto& passage : estimate.passages) row.peak = std::max(row.peak, passage.peak);
  for (const auto& note : estimate.notes) row.message += (row.message.empty() ? "" : "; ") + note;
  return row;
}

void writeRow(const std::string& folder, const EstimateRow& row, const std::string& key, const Estimate* estimate) {
  makeFolder(estimateFolder(folder, row.file));
  auto json = estimate ? Json::parse(estimateJson(*estimate)) : Json::object();
  const auto list = [](const Interval& interval) { return Json{interval.value, interval.low, interval.high}; };
  json["list"] = {{"version", programVersion()},
                  {"key", key},
                  {"failed", row.hasFailed},
                  {"message", row.message},
                  {"depth", list(row.depth)},
                  {"length", list(row.length)},
                  {"misfit", row.misfit},
                  {"peak", row.peak},
                  {"runs", row.runs}};
  writeDurably(rowFile(folder, row.file),
               std::string_view(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
}

std::optional<EstimateRow> readRow(const std::string& folder, const std::string& file, const std::string& key) {
  const auto path = rowFile(folder, file);
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    const auto whole = Json::parse(readWholeFile(path, kLargestFile));
    if (whole.contains("schema") && !whole.contains("list")) return std::nullopt;  // not of a list, or not yet
    const auto& json = whole.at("list");
    if (json.at("version") != programVersion() || json.at("key") != key) return std::nullopt;
    const auto interval = [&](const char* name) {
      const auto& list = json.at(name);
      return Interval{list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
    };
    return EstimateRow{file,
                       json.at("failed").get<bool>(),
                       json.at("message").get<std::string>(),
                       interval("depth"),
                       interval("length"),
                       json.at("misfit").get<double>(),
                       json.at("peak").get<double>(),
                       json.at("runs").get<int>()};
  } catch (const Json::exception&) {
    throw FileError(path, "", "is damaged", "Delete it and estimate this passage again");
  }
}

std::string estimatesFile(const std::string& folder) { return folder + "/estimates.csv"; }

std::string estimatesText(const std::vector<EstimateRow>& rows) {
  std::string text =
      "passage,state,depth [um],depth low [um],depth high [um],length [mm],length low [mm],length high [mm],"
      "misfit,peak [m/s2],runs,message\n";
  for (const auto& row : rows) {
    text += text::csvField(row.file) + (row.hasFailed ? ",failed" : ",done");
    for (const double depth : {row.depth.value, row.depth.low, row.depth.high})
      text += "," + (row.hasFailed ? "" : text::fixedText(1e6 * depth, 1));
    for (const double length : {row.length.value, row.length.low, row.length.high})
      text += "," + (row.hasFailed ? "" : text::fixedText(1e3 * length, 1));
    text += row.hasFailed ? ",,,"
                          : "," + text::fixedText(row.misfit, 2) + "," + text::fixedText(row.peak, 1) + "," +
                                std::to_string(row.runs);
    text += "," + text::csvField(row.message) + "\n";
  }
  return text;
}

}  // namespace squat::estimation
