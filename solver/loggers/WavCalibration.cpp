#include "loggers/WavCalibration.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "text/Text.h"
#include "text/Units.h"

namespace squat::loggers {
namespace {

bool wavIsWordPart(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_'; }

std::string_view wavWithoutBlanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

// What has to stand around words for full scale that mean other things as well.
enum class WavSigns { none, sign, equals };  // equals: "Channel 1: 50 g" is about one channel

// "= 500 m/s2 ...": after the words for full scale.
std::optional<WavCalibration> wavCalibrationAt(std::string_view text, WavSigns signs) {
  text = wavWithoutBlanks(text);
  const bool equals = text.starts_with('='), sign = equals || text.starts_with(':');
  if ((signs == WavSigns::sign && !sign) || (signs == WavSigns::equals && !equals)) return std::nullopt;
  if (sign) text = wavWithoutBlanks(text.substr(1));
  WavCalibration result;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.fullScale);
  if (error != std::errc() || !std::isfinite(result.fullScale) || result.fullScale <= 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text = wavWithoutBlanks(text);
  // The unit goes to the next blank; signs behind it are those of the sentence.
  std::string_view unit = text.substr(0, text.find_first_of(" \t\r\n,;"));
  while (!unit.empty() && (unit.back() == '.' || unit.back() == ')' || unit.back() == ']')) unit.remove_suffix(1);
  while (!unit.empty() && (unit.front() == '(' || unit.front() == '[')) unit.remove_prefix(1);
  const auto* known = text::findUnit(unit);
  if (!known || known->si == "s" || known->si == "Hz" || known->si == "-" || known->si == "%") return std::nullopt;
  result.unit = std::string(unit);
  return result;
}

}  // namespace

std::vector<WavCalibration> wavCalibrations(std::string_view text) {
  struct Words {
    std::string_view text;
    WavSigns signs;
  };
  static constexpr Words all[] = {{"full scale", WavSigns::none}, {"full-scale", WavSigns::none},
                                  {"fullscale", WavSigns::none},  {"fs", WavSigns::sign},
                                  {"1.0", WavSigns::equals},      {"1", WavSigns::equals}};
  constexpr std::size_t longest = 4096;  // people write less, and the search takes the square of it
  text = text.substr(0, longest);
  const std::string lower = text::lowerCase(text);
  std::vector<WavCalibration> found;
  for (const auto& words : all)
    for (std::size_t at = lower.find(words.text); at != std::string::npos; at = lower.find(words.text, at + 1)) {
      const std::size_t end = at + words.text.size();
      if (at > 0 && wavIsWordPart(lower[at - 1])) continue;
      if (end < lower.size() && wavIsWordPart(lower[end])) continue;
      // "Channel 1 = 50 g" is about one channel as well.
      const std::string_view before = text::trimmed(std::string_view(lower).substr(0, at));
      if (words.signs == WavSigns::equals && !before.empty() &&
          std::string_view(",;:.(/").find(before.back()) == std::string_view::npos)
        continue;
      if (auto one = wavCalibrationAt(text.substr(end), words.signs)) found.push_back(*std::move(one));
    }
  return found;
}

}  // namespace squat::loggers
