#include "rcmdx/UnitWords.h"

#include <array>
#include <utility>

#include "text/Text.h"

namespace squat::rcmdx {
namespace {

// In small letters, without blanks, British spelling, singular.
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> unitWords{{
    {"metrepersecondsquared", "m/s2"},
    {"metrepersquaresecond", "m/s2"},
    {"metrepersecond2", "m/s2"},
    {"metrepersecond^2", "m/s2"},
    {"metre/second^2", "m/s2"},
    {"metre/second2", "m/s2"},
    {"millimetrepersecondsquared", "mm/s2"},
    {"gforce", "g"},
    {"standardgravity", "g"},
    {"metrepersecond", "m/s"},
    {"metre/second", "m/s"},
    {"kilometreperhour", "km/h"},
    {"kilometre/hour", "km/h"},
    {"metre", "m"},
    {"millimetre", "mm"},
    {"centimetre", "cm"},
    {"micrometre", "um"},
    {"kilometre", "km"},
    {"second", "s"},
    {"millisecond", "ms"},
    {"nanosecond", "ns"},
    {"degree", "deg"},
}};

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::string symbolOf(std::string_view unit) {
  std::string bare;
  for (const char c : text::lowerCase(text::trimmed(unit, " \t\r\n[]()")))
    if (c != ' ' && c != '_' && c != '-') bare += c;
  replaceAll(bare, "meter", "metre");
  replaceAll(bare, "metres", "metre");
  if (bare.size() > 2 && bare.back() == 's') bare.pop_back();
  for (const auto& [words, symbol] : unitWords)
    if (bare == words) return std::string(symbol);
  return std::string(text::trimmed(unit));
}

}  // namespace squat::rcmdx
