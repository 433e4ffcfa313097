#include "studies/StudyGrid.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "core/Errors.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::studies {
namespace {

constexpr std::size_t maximumValues = 1000;

[[noreturn]] void refuseVariation(const std::string& text, const std::string& allowed) {
  throw CaseError({{"--vary", "'" + text + "'", allowed, "Example: defect.length=20:60:5"}});
}

std::optional<double> number(const std::string& text) { return text::numberIn(text, '.'); }

std::vector<StudyPoint> listOf(const StudyDefinition& definition) {
  std::vector<StudyPoint> points(definition.variations.front().values.size());
  for (std::size_t index = 0; index < points.size(); ++index) {
    points[index].index = index;
    for (const auto& variation : definition.variations) points[index].values.push_back(variation.values.at(index));
  }
  return points;
}

}  // namespace

std::string withoutRounding(double value) {
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 12);
  const double rounded = text::numberFromText({digits.data(), end.ptr}).value_or(value);
  return text::numberText(rounded == 0 ? 0.0 : rounded);
}

Variation variationFromText(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuseVariation(text, "key=first:last:count or key=value,value,...");
  Variation variation{std::string(text::trimmed(text.substr(0, equals))), {}};
  const std::string right(text::trimmed(text.substr(equals + 1)));
  if (variation.key.empty() || right.empty()) refuseVariation(text, "a key, = and its values");
  if (right.find(':') == std::string::npos) {
    variation.values = text::split(right, ',');
    for (const auto& value : variation.values)
      if (value.empty()) refuseVariation(text, "values without empty entries between commas");
    if (variation.values.size() > maximumValues) refuseVariation(text, "at most 1000 values");
  } else {
    const auto range = text::split(right, ':');
    if (range.size() != 3) refuseVariation(text, "first:last:count");
    const auto first = number(range[0]), last = number(range[1]), count = number(range[2]);
    if (!first || !last || !count) refuseVariation(text, "three numbers first:last:count");
    if (*count != std::floor(*count) || *count < 1 || *count > static_cast<double>(maximumValues))
      refuseVariation(text, "a whole count from 1 to 1000");
    if (*count == 1 && *first != *last) refuseVariation(text, "a count of at least 2 where first and last differ");
    const auto n = static_cast<std::size_t>(*count);
    for (std::size_t i = 0; i < n; ++i) {
      const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0;
      variation.values.push_back(withoutRounding(*first * (1 - share) + *last * share));
    }
  }
  const std::set<std::string> distinct(variation.values.begin(), variation.values.end());
  if (distinct.size() != variation.values.size()) refuseVariation(text, "values that differ from each other");
  return variation;
}

std::vector<StudyPoint> gridOf(const StudyDefinition& definition) {
  if (definition.variations.empty())
    throw CaseError({{"--vary", "none", "at least one key with values", "Example: --vary defect.length=20:60:5"}});
  std::size_t count = 1;
  std::set<std::string> keys;
  for (const auto& variation : definition.variations) {
    if (!keys.insert(variation.key).second)
      throw CaseError({{"--vary", variation.key, "given once per key", "Put all its values into one --vary"}});
    count = definition.isList ? variation.values.size() : count * variation.values.size();
    if (count > kMaximumPoints || count == 0)
      throw CaseError({{"--vary", "more than 10000 runs", "1 to 10000 runs", "Use fewer values"}});
  }
  if (definition.isList) return listOf(definition);
  std::vector<StudyPoint> points(count);
  for (std::size_t index = 0; index < count; ++index) {
    points[index].index = index;
    points[index].values.resize(definition.variations.size());
    std::size_t rest = index;
    for (std::size_t v = definition.variations.size(); v-- > 0;) {
      const auto& values = definition.variations[v].values;
      points[index].values[v] = values[rest % values.size()];
      rest /= values.size();
    }
  }
  return points;
}

std::string toText(const StudyDefinition& definition, const StudyPoint& point) {
  std::string text;
  for (std::size_t v = 0; v < definition.variations.size(); ++v)
    text += (v ? ", " : "") + definition.variations[v].key + "=" + point.values[v];
  return text;
}

}  // namespace squat::studies
