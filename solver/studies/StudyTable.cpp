#include "studies/StudyTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "studies/StudyIdentity.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::studies {
namespace {

constexpr std::size_t largestFile = std::size_t{256} << 20;

std::string tablePath(const std::string& folder, const std::optional<Partition>& part) {
  return folder + "/" + (part ? stemOf(*part) : std::string("study")) + ".csv";
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

StudyTable emptyTable(const StudyDefinition& definition, const std::optional<Partition>& part) {
  StudyTable table{definition, part, {}};
  for (auto& point : gridOf(definition))
    if (!part || isInPart(*part, definition, point)) table.rows.push_back({std::move(point), RowState::open, {}, {}});
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

std::vector<std::string> studyFiles(const std::string& folder, const std::optional<Partition>& part) {
  if (part) return {tablePath(folder, part), folder + "/study-parts.json"};
  return {tablePath(folder, part), identityPath(folder)};
}

void writeTable(const StudyTable& table, const std::string& folder) {
  if (!table.part) writeIdentity(table.definition, folder);
  writeDurably(tablePath(folder, table.part), std::string_view(tableText(table)));
}

RowsByValues rowsByValues(StudyTable& table) {
  RowsByValues rows;
  for (auto& row : table.rows) rows[row.point.values] = &row;
  return rows;
}

void takeRows(const std::string& path, std::size_t keys, const RowsByValues& rows) {
  const auto records = text::csvRecords(readWholeFile(path, largestFile));
  if (records.empty() || records[0].size() < keys + 2)
    throw FileError(path, "line 1", "is not the table of this study", "Restore it, or choose another folder with -o");
  for (std::size_t r = 1; r < records.size(); ++r) {
    const auto& record = records[r];
    const std::vector<std::string> values(record.begin(),
                                          record.begin() + static_cast<std::ptrdiff_t>(std::min(keys, record.size())));
    const auto found = rows.find(values);
    if (record.size() != records[0].size() || found == rows.end() ||
        (record[keys] != "done" && record[keys] != "failed"))
      throw FileError(path, "line " + std::to_string(r + 1), "is not a row of this study",
                      "Restore the table, or choose another folder with -o");
    auto& row = *found->second;
    row.state = record[keys] == "done" ? RowState::done : RowState::failed;
    row.message = record.back();
    if (row.state == RowState::done)
      for (std::size_t c = keys + 1; c + 1 < record.size(); ++c)
        row.features.emplace_back(records[0][c], numberFrom(record[c], path, r + 1));
  }
}

std::optional<StudyTable> readTable(const StudyDefinition& definition, const std::string& folder,
                                    const std::optional<Partition>& part) {
  const std::string path = tablePath(folder, part);
  const bool exists = std::filesystem::exists(path);
  if (!part && !hasIdentity(definition, folder)) {
    if (exists)
      throw CaseError({{"-o", path, "a folder without a study.csv, or with its study.json",
                        "study.json is missing: restore it, or choose another folder"}});
    return std::nullopt;
  }
  if (part && !exists) return std::nullopt;
  StudyTable table = emptyTable(definition, part);
  if (!exists) return table;
  takeRows(path, definition.variations.size(), rowsByValues(table));
  return table;
}

}  // namespace squat::studies
