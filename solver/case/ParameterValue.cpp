#include "case/ParameterValue.h"

#include <algorithm>
#include <cmath>

#include "case/DecimalNumber.h"
#include "case/ForceCurveText.h"
#include "case/PointsText.h"
#include "case/Quantity.h"
#include "case/RightSide.h"
#include "case/SeatsText.h"

namespace squat::cases {

namespace {

constexpr std::size_t longestText = 10000;  // of a title, a note or a path

// The accessors take a mutable description; reading through them does not change it.
template <typename Value>
const Value* member(const CaseDescription& description, const Parameter& parameter) {
  const auto* access = std::get_if<Value& (*)(CaseDescription&)>(&parameter.access);
  return access ? &(*access)(const_cast<CaseDescription&>(description)) : nullptr;
}

template <typename Value>
Value* member(CaseDescription& description, const Parameter& parameter) {
  const auto* access = std::get_if<Value& (*)(CaseDescription&)>(&parameter.access);
  return access ? &(*access)(description) : nullptr;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t maximum = 60;
  return text.size() <= maximum ? std::string(text) : std::string(text.substr(0, maximum)) + "...";
}

CaseProblem problem(const Parameter& parameter, std::string_view value, std::string advice) {
  return {parameter.key, shortened(value), allowedText(parameter), std::move(advice)};
}

std::string numberAdvice(const Parameter& parameter, std::string_view text) {
  std::string pointed(text);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  if (pointed != text)
    return "Write a decimal point instead of the comma" +
           (parseQuantity(pointed, parameter) ? ": " + pointed : std::string());
  const auto units = knownUnits(parameter);
  return units.empty() ? "Write a number" : "Write a number, optionally with a unit: " + units;
}

std::optional<CaseProblem> setNumber(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  const auto si = parseQuantity(text, parameter);
  const auto typed = si ? parseDecimal(formatDecimal(*si, parameter.powerOfTen)) : std::nullopt;
  if (!typed) return problem(parameter, text, numberAdvice(parameter, text));
  if (parameter.integer && *typed != std::floor(*typed)) return problem(parameter, text, "Write a whole number");
  if (*typed < parameter.minimum || *typed > parameter.maximum)
    return problem(
        parameter, text,
        "Choose a value within the range" + (parameter.unit == "-" ? "" : "; the unit is " + parameter.unit));
  if (auto* number = member<double>(description, parameter)) *number = *si;
  if (auto* number = member<int>(description, parameter)) *number = static_cast<int>(*typed);
  return std::nullopt;
}

// Names the one with the smallest edit distance; none where no one is near.
std::string choiceAdvice(const Parameter& parameter, std::string_view text) {
  const std::string* nearest = nullptr;
  int smallest = 2 + static_cast<int>(text.size()) / 4;  // farther than that is another word
  for (const auto& name : parameter.choices)
    if (const int distance = text.size() > 100 ? smallest : editDistance(text, name); distance < smallest)
      nearest = &name, smallest = distance;
  return nearest ? "Did you mean " + *nearest + "?" : "Choose one of the names";
}

std::optional<CaseProblem> setChoice(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
  if (found == parameter.choices.end()) return problem(parameter, text, choiceAdvice(parameter, text));
  std::get<ChoiceAccess>(parameter.access)
      .choose(description, static_cast<std::size_t>(found - parameter.choices.begin()));
  return std::nullopt;
}

std::optional<CaseProblem> setBoolean(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  if (text != "true" && text != "false") return problem(parameter, text, "Write true or false");
  *member<bool>(description, parameter) = text == "true";
  return std::nullopt;
}

bool hasControlCharacters(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char letter) {
    return (letter < 0x20 && letter != '\n' && letter != '\t') || letter == 0x7f;
  });
}

// Well-formed UTF-8 (no overlong forms, no surrogates), as TOML and JSON demand.
bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int more = lead < 0x80                   ? 0
                     : lead >= 0xC2 && lead < 0xE0 ? 1
                     : lead >= 0xE0 && lead < 0xF0 ? 2
                     : lead >= 0xF0 && lead < 0xF5 ? 3
                                                   : -1;
    if (more < 0 || text.size() - i <= static_cast<std::size_t>(more)) return false;
    unsigned long code = more == 0 ? lead : lead & (0x3Fu >> more);
    for (int k = 1; k <= more; ++k) {
      const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      if ((next & 0xC0u) != 0x80u) return false;
      code = code << 6 | (next & 0x3Fu);
    }
    if ((more == 2 && (code < 0x800 || (code >= 0xD800 && code < 0xE000))) ||
        (more == 3 && (code < 0x10000 || code > 0x10FFFF)))
      return false;
    i += static_cast<std::size_t>(more) + 1;
  }
  return true;
}

std::optional<CaseProblem> setText(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  if (text.size() > longestText) return problem(parameter, text, "Shorten the text");
  if (!isUtf8(text)) return problem(parameter, "not UTF-8", "Write the text in UTF-8");
  if (hasControlCharacters(text))
    return problem(parameter, "text with control characters", "Remove the control characters");
  *member<std::string>(description, parameter) = text;
  return std::nullopt;
}

std::optional<CaseProblem> setPoints(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  auto points = parsePoints(text, parameter.powerOfTen);
  if (!points) return problem(parameter, text, "Write pairs of numbers like [[0, 0], [5, -0.1], [10, 0]]");
  const std::string wrong = pointsMistake(*points);
  if (!wrong.empty()) return problem(parameter, text, wrong);
  *member<std::vector<ProfilePoint>>(description, parameter) = std::move(*points);
  return std::nullopt;
}

std::optional<CaseProblem> setLines(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  auto lines = parseLines(text, parameter.powerOfTen);
  if (!lines)
    return problem(
        parameter, text,
        "Write the lateral position and the points of each line like [[-10, [[0, 0], [5, -0.1], [10, 0]]], ...]");
  const std::string wrong = linesMistake(*lines);
  if (!wrong.empty()) return problem(parameter, text, wrong);
  *member<std::vector<ProfileLine>>(description, parameter) = std::move(*lines);
  return std::nullopt;
}

std::optional<CaseProblem> setForceCurve(CaseDescription& description, const Parameter& parameter,
                                         std::string_view text) {
  auto curve = parseForceCurve(text);
  if (!curve) return problem(parameter, text, "Write pairs of numbers like [[0, 0], [0.1, 20], [0.2, 70]]");
  const std::string wrong = forceCurveMistake(*curve);
  if (!wrong.empty()) return problem(parameter, text, wrong);
  *member<std::vector<ForcePoint>>(description, parameter) = std::move(*curve);
  return std::nullopt;
}

std::optional<CaseProblem> setSeats(CaseDescription& description, const Parameter& parameter, std::string_view text) {
  auto [seats, wrong] = parseSeats(text);
  if (!wrong.empty()) return problem(parameter, text, wrong);
  *member<std::vector<Seat>>(description, parameter) = std::move(seats);
  return std::nullopt;
}

}  // namespace

std::string allowedText(const Parameter& parameter) {
  switch (parameter.kind) {
    case Kind::number:
      return (parameter.integer ? "a whole number, " : "") + formatDecimal(parameter.minimum) + " to " +
             formatDecimal(parameter.maximum) + (parameter.unit == "-" ? "" : " " + parameter.unit);
    case Kind::choice: {
      std::string text = "one of ";
      for (const auto& name : parameter.choices) text += (name == parameter.choices.front() ? "" : ", ") + name;
      return text;
    }
    case Kind::boolean:
      return "true or false";
    case Kind::text:
      return "text";
    case Kind::points:
      return "pairs of position and height in " + parameter.unit + ", positions ascending";
    case Kind::lines:
      return "lateral position and points of each line in " + parameter.unit + ", both ascending";
    case Kind::forceCurve:
      return "pairs of compression and force in " + parameter.unit + ", both ascending";
    case Kind::seats:
      return "tables with sleeper and " + seatKeys();
  }
  return {};
}

std::string valueText(const CaseDescription& description, const Parameter& parameter) {
  switch (parameter.kind) {
    case Kind::number:
      if (const auto* number = member<double>(description, parameter))
        return formatDecimal(*number, parameter.powerOfTen);
      return std::to_string(*member<int>(description, parameter));
    case Kind::choice: {
      const std::size_t index = std::get<ChoiceAccess>(parameter.access).index(description);
      return index < parameter.choices.size() ? parameter.choices[index] : std::to_string(index);
    }
    case Kind::boolean:
      return *member<bool>(description, parameter) ? "true" : "false";
    case Kind::text:
      return *member<std::string>(description, parameter);
    case Kind::points:
      return formatPoints(*member<std::vector<ProfilePoint>>(description, parameter), parameter.powerOfTen);
    case Kind::lines:
      return formatLines(*member<std::vector<ProfileLine>>(description, parameter), parameter.powerOfTen);
    case Kind::forceCurve:
      return formatForceCurve(*member<std::vector<ForcePoint>>(description, parameter));
    case Kind::seats:
      return formatSeats(*member<std::vector<Seat>>(description, parameter));
  }
  return {};
}

bool isEmptyList(const CaseDescription& description, const Parameter& parameter) {
  if (const auto* points = member<std::vector<ProfilePoint>>(description, parameter)) return points->empty();
  return member<std::vector<ProfileLine>>(description, parameter)->empty();
}

std::optional<CaseProblem> trySetValue(CaseDescription& description, const Parameter& parameter,
                                       std::string_view text) {
  switch (parameter.kind) {
    case Kind::number:
      return setNumber(description, parameter, text);
    case Kind::choice:
      return setChoice(description, parameter, text);
    case Kind::boolean:
      return setBoolean(description, parameter, text);
    case Kind::text:
      return setText(description, parameter, text);
    case Kind::points:
      return setPoints(description, parameter, text);
    case Kind::lines:
      return setLines(description, parameter, text);
    case Kind::forceCurve:
      return setForceCurve(description, parameter, text);
    case Kind::seats:
      return setSeats(description, parameter, text);
  }
  return std::nullopt;
}

void setValue(CaseDescription& description, std::string_view key, std::string_view text) {
  const Parameter* parameter = findParameter(key);
  if (!parameter) throw CaseError({unknownKey(key)});
  if (auto wrong = trySetValue(description, *parameter, text)) throw CaseError({*wrong});
}

void setToDefault(CaseDescription& description, const Parameter& parameter) {
  trySetValue(description, parameter, isList(parameter) ? "[]" : parameter.defaultText);
}

double numberInUnit(const CaseDescription& description, const Parameter& parameter) {
  const auto value = parseDecimal(valueText(description, parameter));
  return value ? *value : std::nan("");
}

std::optional<CaseProblem> checkRange(const CaseDescription& description, const Parameter& parameter) {
  CaseDescription copy;  // setting the text of the value anew makes every check that a case file meets
  return trySetValue(copy, parameter, valueText(description, parameter));
}

CaseProblem unknownKey(std::string_view key) {
  if (const auto right = keyOnRight(key); !right.empty() && !mayDiffer(right)) return noKeyOfRight(right);
  if (!keyOnRight(key).empty()) return {shortened(key), "", "", "a key of the right side, which cannot be used here"};
  const std::string near = nearestKey(key);
  return {shortened(key), "", "",
          "unknown key; " + (near.empty() ? "squat describe lists all keys" : "did you mean " + near + "?")};
}

}  // namespace squat::cases
