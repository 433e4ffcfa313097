#include "detection/Examples.h"

#include <string_view>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

constexpr std::size_t fixedColumns = 7;
constexpr std::size_t columns = fixedColumns + bandCount + 2;

std::string headLine() {
  std::string head = "kind,vehicle,length [mm],depth [mm],speed [m/s],offset [mm],weight";
  for (const auto& band : detectionBands()) head += ",energy " + band.name + " [m2/s3]";
  return head + ",before,reach [m]\n";
}

double numberAt(const std::vector<std::string>& row, std::size_t column, const std::string& path, std::size_t line) {
  const auto value = text::numberFromText(row[column]);
  if (!value)
    throw FileError(path, "line " + std::to_string(line), "'" + row[column] + "' is not a number",
                    "Make the table again with squat examples");
  return *value;
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
    text += ',' + text::numberText(example.before) + ',' + text::numberText(example.reach) + '\n';
  }
  return text;
}

std::vector<Example> readExamples(const std::string& path) {
  constexpr std::size_t largest = std::size_t{64} << 20;
  const auto rows = text::csvRecords(readWholeFile(path, largest));
  std::vector<Example> examples;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() == 1 && rows[i][0].empty()) continue;
    if (rows[i].size() != columns)
      throw FileError(path, "line " + std::to_string(i + 1),
                      "has " + std::to_string(rows[i].size()) + " fields, must be " + std::to_string(columns),
                      "Make the table again with squat examples");
    examples.push_back(exampleFrom(rows[i], path, i + 1));
  }
  if (examples.empty()) throw FileError(path, "", "holds no examples", "Make the table again with squat examples");
  return examples;
}

}  // namespace squat::detection
