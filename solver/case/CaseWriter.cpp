// Writing of case files, and the hash of a case.
#include <span>
#include <utility>

#include "case/CaseFile.h"
#include "case/InputPresets.h"
#include "case/NamedTables.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "case/ShortHash.h"
#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::cases {

namespace {

// A basic TOML string on one line.
std::string tomlString(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    if (letter == '\n')
      result += "\\n";
    else if (letter == '\t')
      result += "\\t";
    else
      result += letter;
  }
  return result + "\"";
}

// One pair of position and height a line, indented by the depth of the brackets.
std::string manyLines(const std::string& points) {
  std::string result;
  std::size_t depth = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool opens = points[i] == '[' && i > 0, closes = points[i] == ']' && i + 1 == points.size();
    if ((opens || closes) && points.size() > 2) result += "\n" + std::string(opens ? 2 * depth : 0, ' ');
    if (points[i] == '[') ++depth;
    if (points[i] == ']') --depth;
    if (points[i] == ' ' && i > 0 && points[i - 1] == ',' && i + 1 < points.size() && points[i + 1] == '[') continue;
    result += points[i];
  }
  return result;
}

std::string tomlValue(const CaseDescription& description, const Parameter& parameter) {
  std::string text = valueText(description, parameter);
  switch (parameter.kind) {
    case Kind::choice:
    case Kind::text:
      return tomlString(text);
    case Kind::points:
    case Kind::lines:
      return manyLines(text);
    default:
      return text;
  }
}

std::string comment(const Parameter& parameter) {
  std::string text = "  # ";
  if (!parameter.unit.empty() && parameter.unit != "-") text += parameter.unit + ": ";
  text += parameter.doc;
  if (parameter.kind == Kind::choice) text += " (" + allowedText(parameter) + ")";
  return text;
}

// Keys that came later, each with the key that gives it an effect. They count only where that one is not at its
// default: what was computed before there were such keys keeps its hash.
struct LaterKey {
  std::string_view key, decidedBy;
};
constexpr LaterKey laterKeys[] = {
    {"model.extent", "model.extent"},
    {"suspension.lateral_stiffness", "model.extent"},
    {"suspension.lateral_damping", "model.extent"},
    {"bogie.wheelbase", "bogie.wheelbase"},
    {"bogie.second_wheelset", "bogie.wheelbase"},
    {"bogie.pitch_radius", "bogie.wheelbase"},
    {"track.seats", "track.seats"},
    {"rail.loss_factor", "rail.loss_factor"},
    {"pad.loss_factor", "pad.loss_factor"},
    {"pad.dynamic_values", "pad.dynamic_values"},
    {"sleeper.loss_factor", "sleeper.loss_factor"},
    {"sleeper.fixed", "sleeper.fixed"},
    {"ballast.loss_factor", "ballast.loss_factor"},
    {"pad.curve", "pad.curve"},
    {"pad.preload", "pad.curve"},
    {"mesh.zone_before", "mesh.zone_before"},
    {"mesh.zone_behind", "mesh.zone_behind"},
    {"sleeper.middle_height", "sleeper.middle_height"},
    {"sleeper.middle_half_length", "sleeper.middle_height"},
    {"defect.from", "defect.from"},
    {"defect.to", "defect.to"},
    {"defect.filter", "defect.filter"},
    {"defect.filter_width", "defect.filter"},
    {"wheelset.tread_points", "wheelset.tread_points"},
    {"wheelset.tread_lines", "wheelset.tread_lines"},
    {"wheelset.tread_position", "wheelset.tread_position"},
    {"rail.irregularity", "rail.irregularity"},
    {"rail.irregularity_levels", "rail.irregularity"},
    {"rail.irregularity_points", "rail.irregularity"},
    {"rail.irregularity_position", "rail.irregularity"},
    {"rail.irregularity_seed", "rail.irregularity"},
    {"rail.irregularity_shortest", "rail.irregularity"},
    {"rail.irregularity_longest", "rail.irregularity"},
    {"rail.irregularity_offset", "rail.irregularity"},
    {"wheelset.brake_discs", "wheelset.brake_discs"},
    {"wheelset.brake_disc_mass", "wheelset.brake_discs"},
    {"wheelset.brake_disc_position", "wheelset.brake_discs"},
};

bool countsInHash(const CaseDescription& description, const Parameter& parameter) {
  if (parameter.key == "title" || parameter.key == "note" || namesTable(parameter)) return false;
  if (isInputPreset(parameter.key)) return false;  // its values count
  for (const auto& [key, decidedBy] : laterKeys)
    if (key == parameter.key) {
      const Parameter& deciding = *findParameter(decidedBy);
      return valueText(description, deciding) != defaultTextOf(deciding);
    }
  return true;
}

// Keys of the right side, by groups.
std::string rightText(const CaseDescription& description) {
  const CaseDescription right = rightOf(description);
  std::string text, group;
  for (const auto& [key, value] : description.right) {
    const Parameter& parameter = *findParameter(key);
    if (std::exchange(group, parameter.group) != parameter.group)
      text += "\n[" + std::string(rightGroup) + "." + group + "]\n";
    text += std::string(lastPart(key)) + " = " + tomlValue(right, parameter) + comment(parameter) + "\n";
  }
  return text;
}

}  // namespace

std::string writeCase(const CaseDescription& description) {
  std::string text = "# A case of Squat Studio. Numbers are in the unit given in the comment.\nschema = " +
                     std::to_string(caseSchema) + "\n";
  std::string group = "case";
  for (const auto& parameter : parameterTable()) {
    if (parameter.group != group) {
      group = parameter.group;
      text += "\n[" + group + "]\n";
    }
    text +=
        std::string(lastPart(parameter.key)) + " = " + tomlValue(description, parameter) + comment(parameter) + "\n";
  }
  text += rightText(description);
  return text;
}

void saveCase(const CaseDescription& description, const std::filesystem::path& path) {
  const std::string text = writeCase(description);
  const auto reads = [&](const std::string& beside) {
    if (writeCase(readCase(beside)) != text)
      throw FileError(path.string(), "", "the written file does not read back correctly");
  };
  writeDurably(path.string(), std::as_bytes(std::span(text)), reads);
}

std::string caseHash(const CaseDescription& description) {
  std::string content;
  for (const auto& parameter : parameterTable())
    if (countsInHash(description, parameter)) content += parameter.key + "=" + valueText(description, parameter) + "\n";
  if (description.extent == ModelExtent::whole)
    for (const auto& [key, text] : description.right)
      if (!namesTable(*findParameter(key))) content += std::string(rightGroup) + "." + key + "=" + text + "\n";
  return shortHash(content);
}

}  // namespace squat::cases
