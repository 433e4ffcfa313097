#include "detection/Examples.h"

#include <array>
#include <string_view>
#include <utility>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

constexpr std::size_t fixedColumns = 7;
constexpr std::size_t formColumn = fixedColumns + bandCount + 2;  // tables of version 0.2 and earlier end here
constexpr std::size_t arrivalColumn = formColumn + 5;             // of tables without whole models, the end
constexpr std::size_t columns = arrivalColumn + 2;
constexpr std::array shapeNames{std::pair{scenario::DefectShape::cosine, "cosine"},
                                std::pair{scenario::DefectShape::wshape, "w-shape"},
                                std::pair{scenario::DefectShape::dipWithWave, "dip-with-wave"},
                                std::pair{scenario::DefectShape::profile, "profile"}};

std::string headLine() {
  std::string head = "kind,vehicle,length [mm],depth [mm],speed [m/s],offset [mm],weight";
  for (const auto& band : detectionBands()) head += ",energy " + band.name + " [m2/s3]";
  return head + ",before,reach [m],shape,middle height,wave length [mm],wave depth [mm],waves" +
         ",first arrival [m2/s3],first arrival other side [m2/s3]\n";
}

double numberAt(const std::vector<std::string>& row, std::size_t column, const std::string& path, std::size_t line) {
  const auto value = text::numberFromText(row[column]);
  if (!value)
    throw FileError(path, "line " + std::to_string(line), "'" + row[column] + "' is not a number",
                    "Make the table again with squat examples");
  return *value;
}

std::string formText(const SquatForm& form) {
  std::string text;
  for (const auto& [shape, name] : shapeNames)
    if (form.shape == shape) text = name;
  for (const double value : {form.middleHeight, 1e3 * form.waveLength, 1e3 * form.waveDepth, form.waveCount})
    text += ',' + text::numberText(value);
  return text;
}

SquatForm formFrom(const std::vector<std::string>& row, const std::string& path, std::size_t line) {
  SquatForm form;
  if (row.size() == formColumn || row[formColumn].empty()) return form;
  for (const auto& [shape, name] : shapeNames)
    if (row[formColumn] == name) form.shape = shape;
  if (form.shape == scenario::DefectShape::none)
    throw FileError(path, "line " + std::to_string(line), "'" + row[formColumn] + "' is no shape",
                    "Write cosine, w-shape, dip-with-wave, profile or nothing");
  const auto number = [&](std::size_t column) { return numberAt(row, formColumn + column, path, line); };
  form.middleHeight = number(1), form.waveLength = 1e-3 * number(2), form.waveDepth = 1e-3 * number(3);
  form.waveCount = number(4);
  return form;
}

Example exampleFrom(const std::vector<std::string>& row, const std::string& path, std::size_t line) {
  const auto number = [&](std::size_t column) { return numberAt(row, column, path, line); };
  Example example;
  try {
    example.kind = kindFromText(row[0]);
  } catch (const CaseError& error) {
    throw FileError(path, "line " + std::to_string(line), error.what());
  }
  example.vehicle = row[1];
  example.length = 1e-3 * number(2);
  example.depth = 1e-3 * number(3);
  example.speed = number(4);
  example.offset = 1e-3 * number(5);
  example.weight = number(6);
  for (std::size_t b = 0; b < bandCount; ++b) example.energy[b] = number(fixedColumns + b);
  example.before = number(fixedColumns + bandCount);
  example.reach = number(fixedColumns + bandCount + 1);
  example.form = formFrom(row, path, line);
  if (row.size() == columns && !row[arrivalColumn].empty()) {
    example.arrival = {number(arrivalColumn), number(arrivalColumn + 1)};
    if (!((*example.arrival)[0] > 0 && (*example.arrival)[1] > 0))
      throw FileError(path, "line " + std::to_string(line), "the energies of the first arrival must be above zero");
  }
  if (!(example.speed > 0) || !(example.weight >= 0))
    throw FileError(path, "line " + std::to_string(line), "the speed must be above zero and the weight not below it");
  return example;
}

}  // namespace

std::string examplesText(const std::vector<Example>& examples) {
  std::string text = headLine();
  for (const auto& example : examples) {
    text += toText(example.kind) + ',' + text::csvField(example.vehicle);
    for (const double value :
         {1e3 * example.length, 1e3 * example.depth, example.speed, 1e3 * example.offset, example.weight})
      text += ',' + text::numberText(value);
    for (const double value : example.energy) text += ',' + text::numberText(value);
    text +=
        ',' + text::numberText(example.before) + ',' + text::numberText(example.reach) + ',' + formText(example.form);
    for (std::size_t k = 0; k < 2; ++k)
      text += ',' + (example.arrival ? text::numberText((*example.arrival)[k]) : std::string());
    text += '\n';
  }
  return text;
}

std::vector<Example> readExamples(const std::string& path) {
  constexpr std::size_t largest = std::size_t{64} << 20;
  const auto rows = text::csvRecords(readWholeFile(path, largest));
  std::vector<Example> examples;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() == 1 && rows[i][0].empty()) continue;
    const auto fields = rows[i].size();
    if (fields != columns && fields != arrivalColumn && fields != formColumn)
      throw FileError(path, "line " + std::to_string(i + 1),
                      "has " + std::to_string(fields) + " fields, must be " + std::to_string(arrivalColumn) + " or " +
                          std::to_string(columns),
                      "Make the table again with squat examples");
    examples.push_back(exampleFrom(rows[i], path, i + 1));
  }
  if (examples.empty()) throw FileError(path, "", "holds no examples", "Make the table again with squat examples");
  return examples;
}

}  // namespace squat::detection
