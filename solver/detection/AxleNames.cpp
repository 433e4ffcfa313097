#include "detection/AxleNames.h"

#include <algorithm>
#include <string_view>

#include "core/Errors.h"
#include "text/Text.h"

namespace squat::detection {
namespace {

struct NameField {
  std::string name;
  char end = 0;  // the mark behind it; 0: the text ends
};

// The first name of `rest`, which is taken off; nothing: a quote is not closed, or something stands behind it.
std::optional<NameField> nextName(std::string_view& rest, std::string_view marks) {
  constexpr char quote = '"';
  NameField field;
  rest = text::trimmed(rest);
  if (rest.starts_with(quote)) {
    rest.remove_prefix(1);
    for (;;) {
      const auto end = rest.find(quote);
      if (end == std::string_view::npos) return std::nullopt;
      field.name += rest.substr(0, end);
      rest.remove_prefix(end + 1);
      if (!rest.starts_with(quote)) break;
      field.name += quote;
      rest.remove_prefix(1);
    }
    rest = text::trimmed(rest);
    if (!rest.empty() && marks.find(rest.front()) == std::string_view::npos) return std::nullopt;
  } else {
    const auto end = std::min(rest.find_first_of(marks), rest.size());
    field.name = text::trimmed(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  if (!rest.empty()) {
    field.end = rest.front();
    rest.remove_prefix(1);
  }
  return field;
}

// `marks`: the comma between sides, and what stands between axles.
void addPairs(const std::string& text, std::string_view marks,
              std::vector<std::pair<std::string, std::string>>& pairs) {
  const auto wrong = [&](const std::string& advice) {
    std::string allowed = "none, or LEFT,RIGHT: the names of two channels";
    if (marks.size() > 1) allowed += ", with a semicolon between wheelsets";
    return CaseError({{"axle", text, allowed, advice}});
  };
  std::vector<NameField> fields;
  std::string_view rest = text;
  do {
    const auto field = nextName(rest, marks);
    if (!field) throw wrong("A name in double quotes ends with a quote; nothing but a comma may follow it");
    fields.push_back(*field);
  } while (fields.back().end != 0);
  for (std::size_t i = 0; i < fields.size(); i += 2) {
    if (fields[i].end != ',') throw wrong("");
    const auto &left = fields[i], &right = fields[i + 1];
    if (right.end == ',') throw wrong(R"(A name that holds a comma stands in double quotes: "box, left","box, right")");
    if (left.name.empty() || right.name.empty()) throw wrong("");
    if (left.name == right.name) throw wrong("Both names are the same");
    pairs.emplace_back(left.name, right.name);
  }
}

}  // namespace

AxleNames axleNamesFromText(const std::vector<std::string>& texts) {
  if (texts.empty()) return std::nullopt;
  std::vector<std::pair<std::string, std::string>> names;
  if (texts.size() == 1 && texts.front() == "none") return names;
  for (const auto& one : texts) addPairs(one, ",", names);
  return names;
}

AxleNames axleNamesFromLine(const std::string& line) {
  const auto text = text::trimmed(line);
  if (text.empty()) return std::nullopt;
  std::vector<std::pair<std::string, std::string>> names;
  if (text != "none") addPairs(line, ",;", names);
  return names;
}

std::string quotedAxleName(const std::string& name) {
  const bool isPlain =
      !name.empty() && name != "none" && name.find_first_of(",;\"") == std::string::npos && text::trimmed(name) == name;
  if (isPlain) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string(2, c) : std::string(1, c);
  return quoted + '"';
}

}  // namespace squat::detection
