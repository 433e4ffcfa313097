// The decimal text of numbers is taken from the source itself, so that units are applied to the digits that the user
// typed (DecimalNumber.h).
#include "case/CaseStatements.h"

#include <algorithm>

#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "case/TomlGuard.h"

namespace squat::cases {

const char* typeName(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

namespace {

// Looking for the nearest of an unknown key takes its time; a list of thousands is not read by anybody.
constexpr std::size_t maximumUnknown = 50, maximumParts = 8;

class Source {
 public:
  explicit Source(std::string_view text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t end = std::min(text.find('\n', from), text.size());
      lines_.push_back(text.substr(from, end - from));
      from = end + 1;
    }
  }

  // The number's own digits where they can be found again, else the shortest text of its value.
  std::string numberText(const toml::node& node, double value) const {
    const auto& region = node.source();
    if (region.begin.line == region.end.line && region.begin.line >= 1 && region.begin.line <= lines_.size()) {
      const std::string_view line = lines_[region.begin.line - 1];
      const std::size_t from = region.begin.column - 1, to = std::min<std::size_t>(region.end.column - 1, line.size());
      if (from < to) {
        std::string token(line.substr(from, to - from));
        token.erase(std::remove(token.begin(), token.end(), '_'), token.end());
        const auto parsed = parseDecimal(token);
        if (parsed && *parsed == value) return token;
      }
    }
    return formatDecimal(value);
  }

 private:
  std::vector<std::string_view> lines_;
};

std::optional<std::string> numberText(const toml::node& node, const Source& source) {
  if (const auto* number = node.as_floating_point()) return source.numberText(node, number->get());
  // Integers beyond 2^53 are no sensible values; as a double they fail the range check.
  if (const auto* number = node.as_integer()) return source.numberText(node, static_cast<double>(number->get()));
  return std::nullopt;
}

std::optional<std::string> pointsText(const toml::node& node, const Source& source) {
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::string text = "[";
  for (const auto& element : *array) {
    const auto* pair = element.as_array();
    if (!pair || pair->size() != 2) return std::nullopt;
    const auto position = numberText((*pair)[0], source), height = numberText((*pair)[1], source);
    if (!position || !height) return std::nullopt;
    text += (text.size() > 1 ? ",[" : "[") + *position + "," + *height + "]";
  }
  return text + "]";
}

std::optional<std::string> linesText(const toml::node& node, const Source& source) {
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::string text = "[";
  for (const auto& element : *array) {
    const auto* line = element.as_array();
    if (!line || line->size() != 2) return std::nullopt;
    const auto lateral = numberText((*line)[0], source), points = pointsText((*line)[1], source);
    if (!lateral || !points) return std::nullopt;
    text += (text.size() > 1 ? ",[" : "[") + *lateral + "," + *points + "]";
  }
  return text + "]";
}

std::optional<std::string> seatsText(const toml::node& node, const Source& source) {
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::string text = "[";
  for (const auto& element : *array) {
    const auto* seat = element.as_table();
    if (!seat) return std::nullopt;
    std::string own;
    for (const auto& [key, value] : *seat) {
      const auto number = numberText(value, source);
      if (!number) return std::nullopt;
      own += (own.empty() ? "" : ", ") + std::string(key.str()) + " = " + *number;
    }
    text += (text.size() > 1 ? ", {" : "{") + own + "}";
  }
  return text + "]";
}

std::optional<std::string> textFor(const toml::node& node, Kind kind, const Source& source) {
  switch (kind) {
    case Kind::number:
      if (const auto* quantity = node.as_string(); quantity && !parseDecimal(quantity->get()))
        return quantity->get();  // "108 km/h"; a plain number stands without quotes
      return numberText(node, source);
    case Kind::boolean:
      if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
      return std::nullopt;
    case Kind::choice:
    case Kind::text:
      if (const auto* value = node.as_string()) return value->get();
      return std::nullopt;
    case Kind::points:
    case Kind::forceCurve:
      return pointsText(node, source);
    case Kind::lines:
      return linesText(node, source);
    case Kind::seats:
      return seatsText(node, source);
  }
  return std::nullopt;
}

std::string formAdvice(const toml::node& node, const Parameter& parameter) {
  const auto* array = node.as_array();
  if (parameter.kind == Kind::number && array) return "Write a decimal point, no comma";
  if (parameter.kind == Kind::choice || parameter.kind == Kind::text) return "Put the text between quotes";
  return isList(parameter) ? "Write pairs of numbers in brackets, with decimal points" : "Write it without quotes";
}

class Statements {
 public:
  Statements(const toml::table& table, const Source& source) : source_(source) {
    for (const auto& [key, node] : table) {
      if (key.str() == "schema") continue;
      if (const auto* right = node.as_table(); right && key.str() == rightGroup) {
        addRight(*right);
        continue;
      }
      if (const auto* group = node.as_table(); group && !findParameter(key.str()))
        addGroup(std::string(key.str()), *group);
      else
        add(std::string(key.str()), node);
    }
    std::stable_sort(stated.begin(), stated.end(), [](const Stated& a, const Stated& b) { return a.line < b.line; });
  }

  std::vector<Stated> stated;

 private:
  void addGroup(const std::string& name, const toml::table& group) {
    for (const auto& [key, node] : group) add(name + "." + std::string(key.str()), node);
    const auto& all = parameterTable();
    const bool known = std::any_of(all.begin(), all.end(), [&](const auto& row) { return row.group == name; });
    if (group.empty() && !known) add(name, group);
  }

  void addRight(const toml::table& right) {
    if (right.empty()) add(std::string(rightGroup) + ".", right);
    for (const auto& [name, node] : right) {
      const std::string start = std::string(rightGroup) + "." + std::string(name.str());
      if (const auto* group = node.as_table(); group && !group->empty())
        for (const auto& [key, value] : *group) add(start + "." + std::string(key.str()), value);
      else
        add(start, node);
    }
  }

  void add(const std::string& key, const toml::node& node) {
    Stated one{key, {}, node.source().begin.line, {}};
    const auto onRight = keyOnRight(key);
    if (!onRight.empty() && !mayDiffer(onRight)) {
      one.typeProblem = ++unknown_ <= maximumUnknown ? noKeyOfRight(onRight) : CaseProblem{key, {}, {}, {}};
    } else if (const Parameter* parameter = findParameter(onRight.empty() ? key : onRight)) {
      if (auto text = textFor(node, parameter->kind, source_))
        one.text = std::move(*text);
      else
        one.typeProblem = CaseProblem{key, typeName(node), allowedText(*parameter), formAdvice(node, *parameter)};
    } else {
      one.typeProblem = ++unknown_ <= maximumUnknown ? unknownKey(key) : CaseProblem{key, {}, {}, {}};
    }
    stated.push_back(std::move(one));
  }

  const Source& source_;
  std::size_t unknown_ = 0;
};

std::string_view lineOf(std::string_view text, std::size_t number) {
  for (; number > 1 && !text.empty(); --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

// What to write instead of "key = 0,15" and "key = 108 km/h", which are no TOML. Empty where it is neither.
std::string valueAdvice(std::string_view line) {
  const auto blanks = " \t\r";
  line = line.substr(0, line.find('#'));
  const auto equals = line.find('=');
  const auto from = line.find_first_not_of(blanks, equals == std::string_view::npos ? line.size() : equals + 1);
  if (from == std::string_view::npos) return {};
  const auto value = line.substr(from, line.find_last_not_of(blanks) + 1 - from);
  const auto number = value.substr(0, value.find_first_not_of("+-.0123456789eE"));
  const auto rest = value.substr(number.size());
  if (!parseDecimal(number) || rest.empty()) return {};
  if (rest.front() != ',') return "Put a value with a unit between quotes: \"" + std::string(value) + "\"";
  const auto decimals = rest.substr(1, rest.find_first_not_of("0123456789", 1) - 1);
  if (decimals.empty()) return {};
  return "Write a decimal point: " + std::string(number) + "." + std::string(decimals);
}

}  // namespace

toml::table parsedToml(std::string_view text, const std::string& origin) {
  if (maximumKeyParts(text) > maximumParts)
    throw FileError(origin, "", "key with more than " + std::to_string(maximumParts) + " parts",
                    "Keys of a case have two parts, like pad.stiffness");
  if (const auto foreign = firstForeignByte(text); foreign.position != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(foreign.position), '\n');
    const bool outside = foreign.where == ForeignByte::Where::outsideStrings;
    throw FileError(origin, "line " + std::to_string(line),
                    outside ? "non-ASCII character outside quotes" : "non-ASCII character after a backslash",
                    outside ? "Put text between quotes" : "Write the text on one line, without the backslash");
  }
  try {
    toml::parse_result parsed = toml::parse(text, origin);
    if (parsed) return std::move(parsed).table();
    throw FileError(origin, "line " + std::to_string(parsed.error().source().begin.line),
                    "invalid TOML: " + std::string(parsed.error().description()),
                    valueAdvice(lineOf(text, parsed.error().source().begin.line)));
  } catch (const TomlAssertion& failed) {
    throw FileError(origin, "", std::string("invalid TOML: ") + failed.what());
  }
}

std::vector<Stated> statementsOf(const toml::table& table, std::string_view text) {
  const Source source(text);
  return Statements(table, source).stated;
}

}  // namespace squat::cases
