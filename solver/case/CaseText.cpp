#include "case/CaseText.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "case/Applicability.h"
#include "case/DecimalNumber.h"
#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/ParameterValue.h"
#include "case/PointsText.h"
#include "case/RightSide.h"
#include "case/SeatsText.h"
#include "scenario/WheelsetMass.h"

namespace squat::cases {

namespace {

std::string padded(std::string text, std::size_t width) {
  std::size_t letters = 0;  // of UTF-8
  for (const char byte : text) letters += (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u;
  if (letters < width) text.append(width - letters, ' ');
  return text;
}

// A value as text in the unit of the case file, short enough for a table.
std::string shortText(const Parameter& parameter, std::string text) {
  if (parameter.kind == Kind::points || parameter.kind == Kind::forceCurve) {
    const auto count = std::count(text.begin(), text.end(), '[') - 1;
    return std::to_string(count) + " points";
  }
  if (parameter.kind == Kind::lines) {
    const auto lines = parseLines(text, 0);
    return std::to_string(lines ? lines->size() : 0) + " lines";
  }
  if (parameter.kind == Kind::seats) {
    const auto count = parseSeats(text).seats.size();
    return std::to_string(count) + (count == 1 ? " seat" : " seats");
  }
  if (parameter.kind == Kind::text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return "\"" + text + "\"";
  }
  return parameter.unit == "-" || parameter.unit.empty() ? text : text + " " + parameter.unit;
}

// Nothing where its file cannot be read: values stand in the case all the same.
PresetValues readablePreset(const char* key, const std::string& name) {
  try {
    return inputPresetValues(key, name);
  } catch (const FileError&) {
    return {};
  }
}

// What a key has where nobody sets it: the table's default, or what a preset sets, and where that is from.
struct Default {
  std::string text, source;
};
Default defaultOf(const CaseDescription& description, const Parameter& parameter) {
  for (const auto& row : presetTable())
    if (row.key == parameter.key)
      return {row.values.at(static_cast<std::size_t>(description.mesh.preset)),
              "mesh preset " + valueText(description, *findParameter("mesh.preset")) + "; " + parameter.source};
  for (const char* key : inputPresetKeys) {
    const auto name = valueText(description, *findParameter(key));
    for (const auto& [own, text] : readablePreset(key, name))
      if (own == parameter.key) return {text, "preset " + name + ": its file in resources/presets names the source"};
  }
  return {defaultTextOf(parameter), parameter.source};
}

std::string sourceText(const CaseDescription& description, const Parameter& parameter, const SetKeys& set) {
  const auto own = defaultOf(description, parameter);
  const bool setHere = std::find(set.begin(), set.end(), parameter.key) != set.end();
  if (!setHere && valueText(description, parameter) == own.text) return own.source;
  std::string who = setHere ? "set here" : "set in the case";
  if (own.text.empty() || isList(parameter)) return who;
  return who + "; default " + shortText(parameter, own.text) + ": " + own.source;
}

std::string rangeText(const Parameter& parameter) {
  if (parameter.kind == Kind::number)
    return formatDecimal(parameter.minimum) + " to " + formatDecimal(parameter.maximum);
  return parameter.kind == Kind::choice ? allowedText(parameter) : std::string();
}

// [kg] that a total mass of 0 stands for.
std::optional<double> derivedValue(const CaseDescription& description, const Parameter& parameter) {
  if (parameter.key != "wheelset.total_mass" || description.wheelset.totalMass > 0) return std::nullopt;
  return scenario::wheelsetMass(description.wheelset);
}

std::string derivedText(const CaseDescription& description, const Parameter& parameter) {
  const auto value = derivedValue(description, parameter);
  return value ? "derived here: " + formatDecimal(std::round(*value * 10) / 10) + " " + parameter.unit + "; " : "";
}

using Json = nlohmann::ordered_json;

Json numberJson(const std::string& text, bool integer) {
  const auto value = parseDecimal(text);
  if (!value) return nullptr;
  return integer ? Json(static_cast<long>(*value)) : Json(*value);
}

Json pointsJson(const std::vector<ProfilePoint>& points) {
  Json array = Json::array();
  for (const auto& point : points) array.push_back({point.position, point.height});
  return array;
}

Json valueJson(const Parameter& parameter, const std::string& text) {
  switch (parameter.kind) {
    case Kind::number:
      return numberJson(text, parameter.integer);
    case Kind::boolean:
      return text == "true";
    case Kind::points:
    case Kind::forceCurve: {
      const auto points = parsePoints(text, 0);
      return points ? pointsJson(*points) : Json::array();
    }
    case Kind::lines: {
      Json array = Json::array();
      if (const auto lines = parseLines(text, 0))
        for (const auto& line : *lines) array.push_back(Json::array({line.lateral, pointsJson(line.points)}));
      return array;
    }
    case Kind::seats: {
      Json array = Json::array();
      for (const auto& seat : parseSeats(text).seats) {
        Json row = Json::object();
        for (const auto& [key, value] : seatEntries(seat)) row[key] = *parseDecimal(value);
        array.push_back(row);
      }
      return array;
    }
    default:
      return text;
  }
}

// What the right side has of its own.
std::string describeRight(const CaseDescription& description) {
  if (description.right.empty()) return {};
  std::string text = "\n[" + std::string(rightGroup) + "]\n";
  for (const auto& [key, value] : description.right) {
    const auto& parameter = *findParameter(key);
    const auto reason = reasonWithoutRight(description, parameter);
    text += "* " + padded(std::string(rightGroup) + "." + key, 34) + " " + padded(shortText(parameter, value), 18) +
            " " + padded(rangeText(parameter), 18) + " " + parameter.doc + " [" +
            (reason.empty() ? "this case" : reason) + "]\n";
  }
  return text;
}

}  // namespace

std::string describeTable(const CaseDescription& description, const SetKeys& set) {
  std::string text, group;
  for (const auto& parameter : parameterTable()) {
    if (parameter.group != group) {
      if (!group.empty()) text += "\n";
      group = parameter.group;
      text += "[" + group + "]\n";
    }
    const std::string value = valueText(description, parameter);
    const char* star = value == defaultTextOf(parameter) ? "  " : "* ";
    const char* effect = applies(description, parameter) ? "" : "no effect here; ";
    text += star + padded(parameter.key, 34) + " " + padded(shortText(parameter, value), 18) + " " +
            padded(rangeText(parameter), 18) + " " + parameter.doc + " [" + effect +
            derivedText(description, parameter) + sourceText(description, parameter, set) + "]\n";
  }
  return text + describeRight(description);
}

namespace {

Json rowJson(const CaseDescription& description, const Parameter& parameter, const SetKeys& set) {
  const bool isNumber = parameter.kind == Kind::number;
  constexpr const char* kinds[] = {"number", "choice", "text", "boolean", "points", "lines", "force curve", "seats"};
  Json row;
  row["key"] = parameter.key;
  row["value"] = valueJson(parameter, valueText(description, parameter));
  row["unit"] = parameter.unit;
  row["default"] = valueJson(parameter, defaultTextOf(parameter));
  row["min"] = isNumber ? Json(parameter.minimum) : Json(nullptr);
  row["max"] = isNumber ? Json(parameter.maximum) : Json(nullptr);
  row["doc"] = parameter.doc;
  row["group"] = parameter.group;
  row["source"] = sourceText(description, parameter, set);
  row["default_source"] = defaultOf(description, parameter).source;
  row["applies"] = applies(description, parameter);
  row["applies_if"] = parameter.condition.empty() ? Json(nullptr) : Json(conditionText(parameter.condition));
  row["kind"] = kinds[static_cast<int>(parameter.kind)];
  if (const auto derived = derivedValue(description, parameter)) row["derived"] = *derived;
  if (parameter.kind == Kind::choice) row["choices"] = parameter.choices;
  return row;
}

// A stated key of the right side; its default is what the left side has.
Json rightJson(const CaseDescription& description, const Parameter& parameter) {
  Json row = rowJson(rightOf(description), parameter, {});
  row["key"] = std::string(rightGroup) + "." + parameter.key;
  row["group"] = std::string(rightGroup) + "." + parameter.group;
  row["default"] = valueJson(parameter, valueText(description, parameter));
  row["source"] = "set in the case";
  row["default_source"] = "as on the left side";
  row["applies"] = reasonWithoutRight(description, parameter).empty();
  return row;
}

}  // namespace

std::string describeJson(const CaseDescription& description, const SetKeys& set) {
  Json all = Json::array();
  for (const auto& parameter : parameterTable()) all.push_back(rowJson(description, parameter, set));
  for (const auto& [key, value] : description.right) all.push_back(rightJson(description, *findParameter(key)));
  return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace squat::cases
