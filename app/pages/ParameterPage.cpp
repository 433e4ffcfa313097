#include "pages/ParameterPage.h"

#include "case/MeshPresets.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "pages/Markdown.h"

namespace squat::pages {

namespace {

using cases::Kind;
using cases::Parameter;

constexpr const char* kParametersIntroduction = R"(# Parameters

Every key of a case, as it stands in the case file: a key `pad.stiffness` is the line `stiffness = ...` in the table
`[pad]`. `squat describe CASE` prints the same for the values of a case. This page is written when the program is built,
from the table by which it reads cases. Defaults are those of the mesh preset `draft`; [below](#mesh-presets) is what
the others change.

Numbers may be typed with another unit of the same kind, as text: `speed = "108 km/h"`.
)";

std::string withUnit(const std::string& value, const std::string& unit) {
  return unit.empty() || unit == "-" ? value : value + " " + unit;
}

std::string defaultCell(const Parameter& parameter) {
  if (parameter.kind == Kind::number) return plainText(withUnit(parameter.defaultText, parameter.unit));
  if (parameter.kind == Kind::text) return codeText("\"" + parameter.defaultText + "\"");
  return codeText(isList(parameter) ? "[]" : parameter.defaultText);
}

std::string rowOf(const Parameter& parameter) {
  return tableRow({codeText(parameter.key), defaultCell(parameter), plainText(cases::allowedText(parameter)),
                   plainText(parameter.doc), plainText(parameter.source)});
}

std::string meshPresets() {
  const auto& names = cases::findParameter("mesh.preset")->choices;
  std::vector<std::string> head{"key"};
  for (const auto& name : names) head.push_back(codeText(name));
  std::string text =
      "\n## Mesh presets\n\nWhat `mesh.preset` (`--mesh`) sets; a key that the case states takes precedence.\n\n";
  text += tableHead(head);
  for (const auto& row : cases::presetTable()) {
    std::vector<std::string> cells{codeText(row.key)};
    for (const char* value : row.values)
      cells.push_back(plainText(withUnit(value, cases::findParameter(row.key)->unit)));
    text += tableRow(cells);
  }
  return text;
}

}  // namespace

std::string parameterPage() {
  std::string text = kParametersIntroduction, group;
  for (const auto& parameter : cases::parameterTable()) {
    if (parameter.group != group) {
      group = parameter.group;
      text += "\n## " + (group == "case" ? std::string("Above all tables") : group) + "\n\n" +
              tableHead({"key", "default", "allowed", "what it is", "where the default comes from"});
    }
    text += rowOf(parameter);
  }
  return text + meshPresets();
}

}  // namespace squat::pages
