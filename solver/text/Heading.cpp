#include "text/Heading.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "text/Text.h"
#include "text/Units.h"

namespace squat::text {
namespace {

struct Words {
  std::string_view unit;                          // SI
  std::initializer_list<std::string_view> whole;  // the name is one of these
  std::initializer_list<std::string_view> first;  // the name begins with one, and no letter follows
};

const std::array<Words, 4>& wordsOfQuantities() {
  static const std::array<Words, 4> words{
      {{"s", {"t", "sec", "seconds"}, {"time", "timestamp", "zeit", "tijd", "temps"}},
       {"m",
        {"km", "pos", "pk"},
        {"position", "chainage", "distance", "mileage", "kilometre", "kilometer", "station", "stationierung", "weg",
         "afstand", "kmpost", "abscisse"}},
       {"m/s", {"v"}, {"speed", "velocity", "geschwindigkeit", "snelheid", "vitesse"}},
       {"m/s2", {"a"}, {"aba", "acc", "accel", "acceleration", "beschleunigung", "versnelling"}}}};
  return words;
}

bool isLetter(char c) { return c >= 'a' && c <= 'z'; }

bool beginsWithWord(std::string_view name, std::string_view word) {
  return name.substr(0, word.size()) == word && (name.size() == word.size() || !isLetter(name[word.size()]));
}

// The unit that a name's last word is, for a quantity; none: it is no such unit. "speed_ms" is in metres a second.
std::string unitFor(std::string_view last, std::string_view quantity) {
  const std::string word = lowerCase(bareUnit(last));
  if (quantity == "m/s" && (word == "ms" || word == "mps")) return "m/s";
  if (quantity == "m/s2" && (word == "ms2" || word == "mps2")) return "m/s2";
  const auto* known = findUnit(word);
  return known && known->si == quantity ? word : std::string();
}

}  // namespace

std::string_view siUnitOfName(std::string_view text) {
  const std::string name = lowerCase(trimmed(text));
  for (const auto& words : wordsOfQuantities()) {
    const bool whole = std::find(words.whole.begin(), words.whole.end(), name) != words.whole.end();
    const auto begins = [&](std::string_view word) { return beginsWithWord(name, word); };
    if (whole || std::any_of(words.first.begin(), words.first.end(), begins)) return words.unit;
  }
  return {};
}

Heading bracketedHeading(std::string_view text) {
  text = trimmed(text);
  const std::size_t open = text.find_last_of("[(");
  if (open != std::string_view::npos && open > 0 && (text.back() == ']' || text.back() == ')'))
    return {std::string(trimmed(text.substr(0, open))),
            std::string(trimmed(text.substr(open + 1, text.size() - open - 2)))};
  return {std::string(text), {}};
}

namespace {

// `quantity`: the SI unit of what the column holds, where it is known; empty: as the name says.
Heading partedHeading(std::string_view text, std::string_view quantity) {
  text = trimmed(text);
  if (auto heading = bracketedHeading(text); !heading.unit.empty()) return heading;
  // From the front, so that "speed km/h" is parted ahead of "km/h".
  for (std::size_t at = text.find_first_of("_ ,/-"); at != std::string_view::npos;
       at = text.find_first_of("_ ,/-", at + 1)) {
    const auto name = trimmed(text.substr(0, at));
    auto last = trimmed(text.substr(at + 1));
    for (const std::string_view joining : {"in ", "en ", "_"})
      if (last.substr(0, joining.size()) == joining) last = trimmed(last.substr(joining.size()));
    const auto unit = unitFor(last, quantity.empty() ? siUnitOfName(name) : quantity);
    if (!name.empty() && !unit.empty()) return {std::string(name), unit};
  }
  return {std::string(text), {}};
}

}  // namespace

Heading headingOf(std::string_view text) { return partedHeading(text, {}); }

Heading headingOf(std::string_view text, std::string_view siUnit) { return partedHeading(text, siUnit); }

}  // namespace squat::text
