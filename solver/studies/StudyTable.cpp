#include "studies/StudyTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::studies {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t largestFile = std::size_t{256} << 20;

std::string tablePath(const std::string& folder) { return folder + "/study.csv"; }
std::string identityPath(const std::string& folder) { return folder + "/study.json"; }

std::string identityText(const StudyDefinition& definition) {
  Json json{{"schema", "squat-study"},          {"schema_version", 1},    {"case", definition.caseName},
            {"case_hash", definition.caseHash}, {"anchor", kStudyAnchor}, {"vary", Json::array()}};
  for (const auto& variation : definition.variations)
    json["vary"].push_back({{"key", variation.key}, {"values", variation.values}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// The case's name may differ (another path to the same file); hash and values count.
bool sameStudy(const Json& json, const StudyDefinition& definition) {
  const Json own = Json::parse(identityText(definition));
  return json.contains("case_hash") && json.contains("vary") && json["case_hash"] == own["case_hash"] &&
         json["vary"] == own["vary"];
}

const char* stateText(RowState state) {
  return state == RowState::done ? "done" : state == RowState::failed ? "failed" : "open";
}

double numberFrom(const std::string& text, const std::string& path, std::size_t line) {
  if (text.empty()) return std::nan("");
  const auto value = text::numberFromText(text);
  if (!value)
    throw FileError(path, "line " + std::to_string(line), "'" + text + "' is not a number",
                    "Restore the table, or choose another folder with -o");
  return *value;
}

}  // namespace

std::size_t StudyTable::count(RowState state) const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const StudyRow& row) { return row.state == state; }));
}

StudyTable emptyTable(const StudyDefinition& definition) {
  StudyTable table{definition, {}};
  for (auto& point : gridOf(definition)) table.rows.push_back({std::move(point), RowState::open, {}, {}});
  return table;
}

std::string tableText(const StudyTable& table) {
  // In the order in which they first appear along the grid, with or without a value: scripts find the same columns in
  // every study.
  std::vector<std::string> names;
  for (const auto& row : table.rows)
    for (const auto& [name, value] : row.features)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  std::string text;
  for (const auto& variation : table.definition.variations) text += text::csvField(variation.key) + ",";
  text += "state";
  for (const auto& name : names) text += "," + text::csvField(name);
  text += ",message\n";
  for (const auto& row : table.rows) {
    if (row.state == RowState::open) continue;
    for (const auto& value : row.point.values) text += text::csvField(value) + ",";
    text += stateText(row.state);
    for (const auto& name : names) {
      const auto found = std::find_if(row.features.begin(), row.features.end(),
                                      [&](const auto& feature) { return feature.first == name; });
      text += "," + (found == row.features.end() ? std::string() : text::numberText(found->second));
    }
    text += "," + text::csvField(row.message) + "\n";
  }
  return text;
}

std::vector<std::string> studyFiles(const std::string& folder) { return {tablePath(folder), identityPath(folder)}; }

void writeTable(const StudyTable& table, const std::string& folder) {
  const std::string identity = identityText(table.definition);
  if (!std::filesystem::exists(identityPath(folder)) || readWholeFile(identityPath(folder), largestFile) != identity)
    writeDurably(identityPath(folder), std::string_view(identity));
  writeDurably(tablePath(folder), std::string_view(tableText(table)));
}

std::optional<StudyTable> readTable(const StudyDefinition& definition, const std::string& folder) {
  if (!std::filesystem::exists(identityPath(folder))) {
    if (std::filesystem::exists(tablePath(folder)))
      throw CaseError({{"-o", tablePath(folder), "a folder without a study.csv, or with its study.json",
                        "study.json is missing: restore it, or choose another folder"}});
    return std::nullopt;
  }
  Json identity;
  try {
    identity = Json::parse(readWholeFile(identityPath(folder), largestFile));
  } catch (const Json::exception& error) {
    throw FileError(identityPath(folder), "", "is damaged", "Remove the folder, or choose another one with -o");
  }
  if (!sameStudy(identity, definition))
    throw CaseError({{"-o", folder, "a new folder, or that of the same case and values",
                      "The folder holds another study: choose another one"}});
  StudyTable table = emptyTable(definition);
  const std::string path = tablePath(folder);
  if (!std::filesystem::exists(path)) return table;
  const auto records = text::csvRecords(readWholeFile(path, largestFile));
  const std::size_t keys = definition.variations.size();
  if (records.empty() || records[0].size() < keys + 2)
    throw FileError(path, "line 1", "is not the table of this study", "Restore it, or choose another folder with -o");
  for (std::size_t r = 1; r < records.size(); ++r) {
    const auto& record = records[r];
    const std::vector<std::string> values(record.begin(),
                                          record.begin() + static_cast<std::ptrdiff_t>(std::min(keys, record.size())));
    const auto row = std::find_if(table.rows.begin(), table.rows.end(),
                                  [&](const StudyRow& candidate) { return candidate.point.values == values; });
    if (record.size() != records[0].size() || row == table.rows.end() ||
        (record[keys] != "done" && record[keys] != "failed"))
      throw FileError(path, "line " + std::to_string(r + 1), "is not a row of this study",
                      "Restore the table, or choose another folder with -o");
    row->state = record[keys] == "done" ? RowState::done : RowState::failed;
    row->message = record.back();
    if (row->state == RowState::done)
      for (std::size_t c = keys + 1; c + 1 < record.size(); ++c)
        row->features.emplace_back(records[0][c], numberFrom(record[c], path, r + 1));
  }
  return table;
}

}  // namespace squat::studies
