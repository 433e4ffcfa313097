#include "calibration/EvaluationTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "case/CaseDescription.h"
#include "case/ShortHash.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::calibration {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kLargestFile = std::size_t{256} << 20;
constexpr std::size_t kColumnsBefore = 4;  // stage, mesh, state, misfit
constexpr const char* kFolderAdvice = "Restore the folder, or choose another one with -o";

std::string tablePath(const std::string& folder) { return folder + "/calibration.csv"; }
std::string residualPath(const std::string& folder) { return folder + "/calibration-residuals.csv"; }
std::string identityPath(const std::string& folder) { return folder + "/calibration.json"; }
std::string partsFolder(const std::string& folder) { return folder + "/parts"; }

// All that decides which points a search visits and what they give.
Json identityOf(const CalibrationDefinition& definition) {
  Json json{{"schema", "squat-calibration"}, {"schema_version", 1}};
  json["case_hash"] = definition.caseHash;
  for (const auto& input : definition.inputs)
    json["free"].push_back(input.key() + "=" + valueText(input.low) + ":" + valueText(input.high));
  std::string data;
  for (const auto& target : definition.targets.statements) {
    const auto& s = target.statement;
    data += s.run + "," + s.against + "," + s.measure + "," + s.point + ",";
    for (const double number :
         {s.low, s.high, s.expected.value_or(NAN), s.near, s.band.first, s.band.second, target.weight})
      data += text::numberText(number) + ",";
  }
  for (const auto& run : definition.targets.runs) {
    auto overrides = definition.overrides;
    overrides.values.insert(overrides.values.end(), run.sets.begin(), run.sets.end());
    data += run.name + "," + cases::caseHash(cases::loadCase(run.caseName, overrides)) + ",";
  }
  const auto addNumbers = [&](std::initializer_list<double> numbers) {
    for (const double number : numbers) data += text::numberText(number) + ",";
  };
  const auto addFile = [&](const std::string& path) { data += readWholeFile(path, kLargestFile); };
  for (const auto& target : definition.targets.signals) {
    data += target.run + "," + target.reading.column + ",";
    addNumbers({target.weight, target.before, target.after, target.cutoff, target.noise, target.reading.speed,
                target.reading.rate});
    std::for_each(target.files.begin(), target.files.end(), addFile);
  }
  for (const auto& target : definition.targets.receptances) {
    data += target.point + ",";
    addNumbers({target.weight, target.lowest, target.highest, target.tolerance});
    addFile(target.file);
  }
  for (const auto& target : definition.targets.decays) {
    addNumbers({target.weight, target.lowest, target.highest, target.tolerance});
    addFile(target.file);
  }
  json["targets"] = definition.targets.names();
  json["data_hash"] = cases::shortHash(data);
  json["meshes"] = {definition.searchMesh, definition.confirmMesh};
  json["evaluations"] = definition.evaluations;
  // As it is read back: names of files need not be UTF-8.
  return Json::parse(json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Stage stageFrom(const std::string& text) {
  for (const auto stage : {Stage::start, Stage::global, Stage::local, Stage::derivatives, Stage::spread})
    if (toText(stage) == text) return stage;
  return Stage::confirm;
}

std::string fieldOf(const std::optional<double>& value) { return value ? text::numberText(*value) : std::string(); }

double numberIn(const std::string& field, const std::string& path, std::size_t line) {
  if (const auto value = text::numberFromText(field)) return *value;
  throw FileError(path, "line " + std::to_string(line), "'" + field + "' is not a number", kFolderAdvice);
}

}  // namespace

std::string toText(Stage stage) {
  switch (stage) {
    case Stage::start:
      return "start";
    case Stage::global:
      return "global";
    case Stage::local:
      return "local";
    case Stage::derivatives:
      return "derivatives";
    case Stage::spread:
      return "spread";
    case Stage::confirm:
      break;
  }
  return "confirm";
}

std::vector<std::string> calibrationFiles(const std::string& folder) {
  return {tablePath(folder), residualPath(folder), identityPath(folder)};
}

std::string partFolder(const std::string& folder, const studies::Partition& part) {
  return partsFolder(folder) + "/" + studies::stemOf(part, "calibrate");
}

EvaluationTable::EvaluationTable(const CalibrationDefinition& definition, std::string folder)
    : definition_(definition), folder_(std::move(folder)) {
  makeFolder(folder_);
  const auto own = identityOf(definition_);
  if (!std::filesystem::exists(identityPath(folder_))) {
    for (const auto& path : {tablePath(folder_), residualPath(folder_)})
      if (std::filesystem::exists(path))
        throw CaseError({{"-o", path, "a folder without such a file, or with the calibration.json that belongs to it",
                          "Choose another folder, for example -o out/calibration"}});
    writeDurably(identityPath(folder_), std::string_view(own.dump(2) + "\n"));
    write();
    return;
  }
  requireSame(folder_);
  rows_ = read(folder_);
}

void EvaluationTable::requireSame(const std::string& folder) const {
  Json identity;
  try {
    identity = Json::parse(readWholeFile(identityPath(folder), kLargestFile));
  } catch (const Json::exception&) {
    throw FileError(identityPath(folder), "", "is damaged", kFolderAdvice);
  }
  if (identity != identityOf(definition_))
    throw CaseError({{"-o", folder, "a new folder, or that of the same case, targets and limits",
                      "The folder holds another calibration: choose another one"}});
}

void EvaluationTable::takeParts() {
  std::error_code none;
  std::vector<std::string> folders;
  for (const auto& entry : std::filesystem::directory_iterator(partsFolder(folder_), none))
    if (std::filesystem::exists(identityPath(entry.path().string()))) folders.push_back(entry.path().string());
  std::sort(folders.begin(), folders.end());
  for (const auto& folder : folders) {
    requireSame(folder);
    for (auto& row : read(folder)) ofParts_.push_back(std::move(row));
  }
}

const Evaluation* EvaluationTable::find(const std::string& mesh, const Values& values) const {
  for (const auto* rows : {&rows_, &ofParts_})
    for (const auto& row : *rows)
      if (row.mesh == mesh && row.values == values) return &row;
  return nullptr;
}

void EvaluationTable::add(Evaluation evaluation) {
  for (const auto& row : rows_)
    if (row.mesh == evaluation.mesh && row.values == evaluation.values) return;
  rows_.push_back(std::move(evaluation));
  write();
}

void EvaluationTable::write() const {
  std::string text = "stage,mesh,state,misfit";
  for (const auto& input : definition_.inputs)
    text += "," + text::csvField(input.key() + " [" + input.parameter->unit + "]");
  for (const auto& name : definition_.targets.names()) text += "," + text::csvField(name) + ",met";
  text += ",message\n";
  std::string residuals = "point,target,residuals\n";
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto& row = rows_[i];
    text += toText(row.stage) + "," + row.mesh + "," + (row.hasFailed ? "failed" : "done") + "," +
            (row.hasFailed ? "" : text::numberText(row.misfit));
    for (const double value : row.values) text += "," + valueText(value);
    for (std::size_t t = 0; t < definition_.targets.count(); ++t) {
      const bool is = !row.hasFailed;
      text += "," + (is ? fieldOf(row.targets[t].value) : "") + "," + (!is ? "" : row.targets[t].isMet ? "yes" : "no");
      residuals += std::to_string(i + 1) + "," + std::to_string(t + 1);
      if (is) residuals += "," + text::numberText(row.targets[t].misfit);
      if (is)
        for (const double residual : row.targets[t].residuals) residuals += "," + text::numberText(residual);
      residuals += "\n";
    }
    text += "," + text::csvField(row.message) + "\n";
  }
  writeDurably(residualPath(folder_), std::string_view(residuals));
  writeDurably(tablePath(folder_), std::string_view(text));
}

std::vector<Evaluation> EvaluationTable::read(const std::string& folder) const {
  std::vector<Evaluation> rows;
  const auto path = tablePath(folder), residualTable = residualPath(folder);
  if (!std::filesystem::exists(path)) return rows;
  const auto table = text::csvRecords(readWholeFile(path, kLargestFile));
  const auto residuals = text::csvRecords(readWholeFile(residualTable, kLargestFile));
  const std::size_t inputs = definition_.inputs.size(), targets = definition_.targets.count();
  // A stop between the two files leaves the residuals of one point more.
  if (table.empty() || residuals.size() < 1 + (table.size() - 1) * targets)
    throw FileError(residualTable, "", "is shorter than calibration.csv", kFolderAdvice);
  for (std::size_t r = 1; r < table.size(); ++r) {
    const auto& record = table[r];
    if (record.size() != kColumnsBefore + inputs + 2 * targets + 1)
      throw FileError(path, "line " + std::to_string(r + 1), "is not a row of this calibration", kFolderAdvice);
    Evaluation row;
    row.stage = stageFrom(record[0]), row.mesh = record[1], row.hasFailed = record[2] == "failed";
    row.message = record.back();
    for (std::size_t i = 0; i < inputs; ++i) row.values.push_back(numberIn(record[kColumnsBefore + i], path, r + 1));
    if (!row.hasFailed) row.misfit = numberIn(record[3], path, r + 1);
    for (std::size_t t = 0; t < targets && !row.hasFailed; ++t) {
      TargetValue value;
      const auto& field = record[kColumnsBefore + inputs + 2 * t];
      if (!field.empty()) value.value = numberIn(field, path, r + 1);
      value.isMet = record[kColumnsBefore + inputs + 2 * t + 1] == "yes";
      const std::size_t line = 1 + (r - 1) * targets + t;
      const auto& numbers = residuals[line];
      if (numbers.size() < 3) throw FileError(residualTable, "line " + std::to_string(line + 1), "is too short");
      value.misfit = numberIn(numbers[2], residualTable, line + 1);
      for (std::size_t c = 3; c < numbers.size(); ++c)
        value.residuals.push_back(numberIn(numbers[c], residualTable, line + 1));
      row.targets.push_back(std::move(value));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace squat::calibration
